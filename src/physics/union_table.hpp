#pragma once

#include <array>
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
/// `lanes` consecutive entities: slots stand by corner and entity, and where consecutive entities lead to consecutive slots,
/// a run bit says so and the sweep loads instead of gathering.
///
/// Slots: one for each received mass, at least one void slot that never moves, then the unions that this rank advances, at
/// the start in the order of their vertices; the parts of split unions are appended. Entities from entity_count() to
/// stride() are void and rest on the void slot.
class UnionTable {
public:
    static constexpr int lanes = 8;

    explicit UnionTable(const Network& network);

    [[nodiscard]] std::size_t stride() const { return stride_; }
    [[nodiscard]] std::size_t batches() const { return stride_ / lanes; }
    [[nodiscard]] Slot first_advanced() const { return first_advanced_; }
    [[nodiscard]] Slot end() const { return end_; }
    /// Slots in whole chunks of `lanes`: the length that arrays by slot need.
    [[nodiscard]] std::size_t capacity() const { return first_mass_.size(); }

    [[nodiscard]] Slot slot(LocalMass m) const {
        return Slot{slot_[static_cast<std::size_t>(corner_of(m)) * stride_ + entity_of(m).index()]};
    }
    [[nodiscard]] LocalMass smallest_mass(Slot s) const { return first_mass_[s.index()]; }
    /// Calls action(mass) for the masses of an advanced union, ascending.
    template <class Action>
    void for_each_mass(Slot s, Action&& action) const {
        for (LocalMass m = first_mass_[s.index()]; m != LocalMass{}; m = next_mass_[m.index()]) {
            action(m);
        }
    }
    /// The same masses in a list, which is cleared first.
    void masses(Slot s, std::vector<LocalMass>& found) const;
    [[nodiscard]] int mass_count(Slot s) const;

    /// Slots of a corner's masses by entity.
    [[nodiscard]] const std::int32_t* slots_of_corner(int corner) const {
        return slot_.data() + static_cast<std::size_t>(corner) * stride_;
    }
    /// By batch: bit c is set where the slots of corner c are consecutive.
    [[nodiscard]] const std::uint8_t* batch_runs() const { return batch_runs_.data(); }
    /// By batch: 1 where adding the forces of whole corners, those of `corners_added_first` before the others, reaches every
    /// union in ascending order of its masses.
    [[nodiscard]] const std::uint8_t* batch_adds_by_corner() const { return batch_adds_by_corner_.data(); }
    /// The corners on the upper x side: where they coincide with a corner of the lower side, that belongs to a later entity.
    static constexpr std::array<int, 4> corners_added_first{1, 2, 5, 6};
    static constexpr std::array<int, 4> corners_added_last{0, 3, 4, 7};

    /// Gives a part (ascending masses) a slot of its own, which is returned; the rest must be kept by keep().
    Slot append(std::span<const LocalMass> part);
    /// Reduces a slot to some of its masses (ascending).
    void keep(Slot s, std::span<const LocalMass> part);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    Slot add_slot();
    void assign(Slot s, std::span<const LocalMass> masses);
    void update_batch(std::size_t batch);
    [[nodiscard]] bool adds_by_corner(std::size_t batch) const;

    std::size_t stride_;
    Slot first_advanced_;
    Slot end_;
    std::vector<std::int32_t> slot_;
    std::vector<std::uint8_t> batch_runs_;
    std::vector<std::uint8_t> batch_adds_by_corner_;
    std::vector<LocalMass> first_mass_;  ///< by slot
    std::vector<LocalMass> next_mass_;   ///< by local mass, within its union
};

}  // namespace cracksim::physics
