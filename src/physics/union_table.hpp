#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/block.hpp"
#include "core/ids.hpp"
#include "physics/network.hpp"

namespace cracksim::physics {

/// Place of a Mass-union's motion in this rank's arrays. Slots say nothing outside this rank and never reach a result's bits.
using Slot = Id<struct SlotTag, std::int32_t>;

/// Which masses move as one: mass -> slot, and slot -> masses in ascending order. Laid out for a sweep over batches of
/// `lanes` consecutive entities and over chunks of `lanes` consecutive slots; where consecutive lanes lead to consecutive
/// places, a run bit says so and the sweep loads instead of gathering.
///
/// Slots: one for each received mass, at least one void slot that never moves, then the unions that this rank advances, at
/// the start in the order of their vertices; the parts of split unions are appended. An index into the forces is
/// corner * stride() + entity; entities from entity_count() to stride() are void and rest on the void slot.
class UnionTable {
public:
    static constexpr int lanes = 8;
    /// Masses of a union at most: the corners that meet at a vertex of a block of hexahedra.
    static constexpr int max_masses = 8;

    explicit UnionTable(const Network& network);

    [[nodiscard]] std::size_t stride() const { return stride_; }
    [[nodiscard]] std::size_t batches() const { return stride_ / lanes; }
    [[nodiscard]] Slot first_advanced() const { return first_advanced_; }
    [[nodiscard]] Slot end() const { return end_; }
    /// Slots in whole chunks: the length that arrays by slot need.
    [[nodiscard]] std::size_t capacity() const { return chunks() * lanes; }
    [[nodiscard]] std::size_t chunks() const { return width_.size(); }
    [[nodiscard]] std::size_t first_chunk() const { return first_advanced_.index() / lanes; }

    [[nodiscard]] Slot slot(LocalMass m) const { return Slot{slot_[place(m)]}; }
    [[nodiscard]] std::int32_t mass_count(Slot s) const { return mass_count_[s.index()]; }
    /// The masses of a union, ascending, appended to an empty list.
    void masses(Slot s, std::vector<LocalMass>& found) const;
    [[nodiscard]] LocalMass smallest_mass(Slot s) const { return mass_at(contribution(s, 0)); }

    /// Slots of a corner's masses by entity; whether a batch's lie in a run, bit by corner.
    [[nodiscard]] const std::int32_t* slots_of_corner(int corner) const {
        return slot_.data() + static_cast<std::size_t>(corner) * stride_;
    }
    [[nodiscard]] const std::uint8_t* batch_runs() const { return batch_runs_.data(); }
    /// Force indices that a chunk's unions sum, k-th masses of all lanes together: [chunk][k][lane].
    [[nodiscard]] const std::int32_t* contributions(std::size_t chunk) const {
        return contributions_.data() + chunk * max_masses * lanes;
    }
    [[nodiscard]] const std::uint8_t* chunk_runs() const { return chunk_runs_.data(); }
    /// Masses of a chunk's largest union.
    [[nodiscard]] const std::uint8_t* chunk_width() const { return width_.data(); }
    [[nodiscard]] std::int32_t contribution(Slot s, int k) const {
        return contributions(s.index() / lanes)[static_cast<std::size_t>(k) * lanes + s.index() % lanes];
    }
    [[nodiscard]] std::size_t place(LocalMass m) const {
        return static_cast<std::size_t>(corner_of(m)) * stride_ + entity_of(m).index();
    }
    [[nodiscard]] LocalMass mass_at(std::int32_t force_index) const {
        const auto index = static_cast<std::size_t>(force_index);
        return local_mass(LocalEntity{static_cast<std::int32_t>(index % stride_)}, static_cast<int>(index / stride_));
    }

    /// Leaves `part` in a slot of its own, which is returned; the caller takes the masses from their old slot by keep().
    Slot append(std::span<const LocalMass> part);
    /// Reduces a slot to some of its masses.
    void keep(Slot s, std::span<const LocalMass> part) { assign(s, part); }

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void add_chunk();
    void assign(Slot s, std::span<const LocalMass> masses);
    void update_chunk(std::size_t chunk);
    void update_batch(std::size_t batch, int corner);

    std::size_t stride_;
    Slot first_advanced_;
    Slot end_;
    std::vector<std::int32_t> slot_;
    std::vector<std::uint8_t> batch_runs_;
    std::vector<std::int32_t> contributions_;
    std::vector<std::uint8_t> chunk_runs_;
    std::vector<std::uint8_t> width_;
    std::vector<std::int8_t> mass_count_;
};

}  // namespace cracksim::physics
