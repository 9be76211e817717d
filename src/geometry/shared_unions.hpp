#pragma once

#include <cstddef>
#include <span>

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "core/ids.hpp"

namespace cracksim::geometry {

/// Which of this rank's masses share a Mass-union, as the starting unions and the splits tell it: by mass, the next one
/// around its union.
class SharedUnions {
public:
    /// Every mass by itself.
    explicit SharedUnions(std::size_t masses);

    /// These masses are a union from now on. A split tells all its parts.
    void set(std::span<const LocalMass> masses);

    /// Calls visit(other) for the entities that share unions with this one, each perhaps several times.
    template <class Visit>
    void for_each_neighbour(LocalEntity entity, const Visit& visit) const {
        for (int corner = 0; corner < Hexahedron::corners; ++corner) {
            const LocalMass mass = local_mass(entity, corner);
            for (LocalMass m = next_[mass]; m != mass; m = next_[m]) {
                visit(entity_of(m));
            }
        }
    }

    [[nodiscard]] bool joins(LocalEntity a, LocalEntity b) const;

    [[nodiscard]] std::size_t memory_bytes() const { return next_.bytes(); }

private:
    IdArray<LocalMass, LocalMass> next_;
};

}  // namespace cracksim::geometry
