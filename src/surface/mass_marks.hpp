#pragma once

#include <cstddef>
#include <cstdint>

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "core/ids.hpp"

namespace cracksim::surface {

/// A set of this rank's masses, one bit for each.
class MassMarks {
public:
    explicit MassMarks(std::size_t entities) : bits_(entities) {}

    [[nodiscard]] bool contains(LocalMass mass) const { return (bits_[entity_of(mass)] & bit(mass)) != 0; }
    /// Returns false if the set already contains the mass.
    bool insert(LocalMass mass) {
        const bool is_new = !contains(mass);
        bits_[entity_of(mass)] = static_cast<std::uint8_t>(bits_[entity_of(mass)] | bit(mass));
        return is_new;
    }
    /// Removes all masses of an entity.
    void clear(LocalEntity entity) { bits_[entity] = 0; }
    [[nodiscard]] std::size_t bytes() const { return bits_.bytes(); }

private:
    static unsigned bit(LocalMass mass) { return 1U << static_cast<unsigned>(corner_of(mass)); }

    IdArray<LocalEntity, std::uint8_t> bits_;
};

}  // namespace cracksim::surface
