#pragma once

#include <cstddef>
#include <span>

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "core/ids.hpp"

namespace cracksim::geometry {

/// The Mass-unions of this rank's masses, after the starting unions and all splits so far. Each union is a circular
/// list: each mass has the next mass of its union.
class SharedUnions {
public:
    /// Starts with a union of its own for each mass.
    explicit SharedUnions(std::size_t masses);

    /// Makes these masses one union. After a split, call it for every part.
    void set(std::span<const LocalMass> masses);

    /// Calls visit(other) for each entity that shares a union with this one, possibly several times.
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
