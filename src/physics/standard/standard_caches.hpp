#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/lattice/bfloat16.hpp"
#include "physics/lattice/row_caches.hpp"

namespace cracksim::physics {

/// Data derived from network and state that make the sweep over standard entities fast.
struct StandardCaches {
    StandardCaches(const Network& network, const State& state);

    [[nodiscard]] std::size_t memory_bytes() const;

    RowCaches rows;
    std::vector<std::uint8_t> present;    ///< [batch]: one bit for each lane that has an entity
    std::vector<std::uint8_t> owned;      ///< [batch]: one bit for each lane whose entity this rank owns
    std::vector<Bfloat16> limits;         ///< [site]: largest stress over E up to which no interface of it can open
    std::vector<std::uint8_t> stretched;  ///< [batch]: one bit for each lane that the sweep found beyond its limit
};

}  // namespace cracksim::physics
