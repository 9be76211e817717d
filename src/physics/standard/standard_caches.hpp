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

    /// Sets the limits of the entities at some vertices, after duplets there became inactive.
    void set_limits(const Network& network, const State& state, std::span<const VertexSite> weakened);
    [[nodiscard]] std::size_t memory_bytes() const;

    RowCaches rows;
    std::vector<std::uint8_t> present;  ///< [batch]: one bit for each lane that has an entity
    std::vector<std::uint8_t> owned;    ///< [batch]: one bit for each lane whose entity this rank owns
    /// [site]: the stress over E up to which no face of the entity can open; infinite without a face that has active
    /// duplets, and with sensors `normal`.
    std::vector<Bfloat16> limits;
    std::vector<std::uint8_t> stretched;  ///< [batch]: one bit for each lane that the sweep found beyond its limit
};

}  // namespace cracksim::physics
