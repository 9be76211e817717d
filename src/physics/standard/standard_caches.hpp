#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/symmetric_tensor.hpp"
#include "physics/lattice/bfloat16.hpp"
#include "physics/lattice/row_caches.hpp"
#include "physics/standard/sweep/standard_view.hpp"

namespace cracksim::physics {

/// The stresses that a sweep stored. Memory that no sweep wrote to takes no pages. A copy has none stored.
class StoredStresses {
public:
    explicit StoredStresses(std::size_t batches)
        : stored_(batches, 0), by_batch_{std::make_unique_for_overwrite<BatchStress[]>(batches)} {}
    StoredStresses(const StoredStresses& other) : StoredStresses{other.stored_.size()} {}
    StoredStresses& operator=(const StoredStresses&) = delete;
    StoredStresses(StoredStresses&&) = default;
    StoredStresses& operator=(StoredStresses&&) = default;
    ~StoredStresses() = default;

    /// [batch]: one bit for each lane whose stress is stored
    [[nodiscard]] std::uint8_t* stored() { return stored_.data(); }
    [[nodiscard]] BatchStress* by_batch() { return by_batch_.get(); }
    [[nodiscard]] bool is_stored(std::size_t site) const {
        return (unsigned{stored_[site / Lattice::lanes]} >> site % Lattice::lanes & 1U) != 0;
    }
    [[nodiscard]] SymmetricTensor of(std::size_t site) const {
        return by_batch_[site / Lattice::lanes].of(site % Lattice::lanes);
    }
    [[nodiscard]] std::size_t memory_bytes() const {
        return stored_.size() +
               static_cast<std::size_t>(std::ranges::count_if(stored_, std::identity{})) * sizeof(BatchStress);
    }

private:
    std::vector<std::uint8_t> stored_;
    std::unique_ptr<BatchStress[]> by_batch_;
};

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
    StoredStresses stresses;
};

}  // namespace cracksim::physics
