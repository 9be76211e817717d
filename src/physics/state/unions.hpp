#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/ids.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/state/motion.hpp"
#include "physics/problem/network.hpp"

namespace cracksim::physics {

/// Which masses move as one. The masses of a vertex that share a union share a label, which follows from the split state alone:
/// its corner for a mass on its own; else base_plane in the part with the vertex's smallest mass, and in the others the corner of
/// their smallest mass. A union's motion is in the plane of its label. The label of a received mass is what its owner says.
class UnionTable {
public:
    explicit UnionTable(const Network& network);

    [[nodiscard]] const Lattice& lattice() const { return *lattice_; }
    [[nodiscard]] int label(LocalMass m) const { return label_[m.index()]; }
    /// Touched: this rank advances the unions of the vertex, and has all their masses.
    [[nodiscard]] bool is_touched(VertexSite v) const { return in_use_[v.index()] != 0; }
    [[nodiscard]] Slot slot(LocalMass m) const { return slot_of(lattice_->vertex(m), label(m)); }
    /// Of its local masses; none if the slot is empty.
    [[nodiscard]] LocalMass smallest_mass(Slot s) const;
    /// Calls action(mass) for the masses of an advanced union, ascending.
    template <class Action>
    void for_each_mass(Slot s, Action&& action) const {
        lattice_->for_each_mass_at(vertex_of(s), [&](LocalMass m) {
            if (label(m) == plane_of(s)) {
                action(m);
            }
        });
    }
    /// The same masses in a list, which is cleared first.
    void masses(Slot s, std::vector<LocalMass>& found) const;
    [[nodiscard]] int mass_count(Slot s) const;
    /// Calls action(slot) for the unions that this rank advances, by vertex and plane.
    template <class Action>
    void for_each_advanced_slot(Action&& action) const {
        for (VertexSite v{0}; v.index() < in_use_.size(); ++v) {
            for (unsigned in_use = in_use_[v.index()]; in_use != 0; in_use &= in_use - 1) {
                action(slot_of(v, std::countr_zero(in_use)));
            }
        }
    }
    /// The same with each union's smallest mass: action(slot, smallest).
    template <class Action>
    void for_each_advanced(Action&& action) const {
        for_each_advanced_slot([&](Slot s) { action(s, smallest_of_advanced(s)); });
    }
    /// By the rules for labels, and so without a look at those of the vertex's other masses.
    [[nodiscard]] LocalMass smallest_of_advanced(Slot s) const {
        return plane_of(s) == base_plane ? lattice_->smallest_at(vertex_of(s))
                                         : lattice_->mass_at(vertex_of(s), plane_of(s));
    }
    /// Slots of all unions that this rank advances, by vertex and plane.
    [[nodiscard]] std::vector<Slot> advanced() const;

    /// Makes some masses of a touched vertex (ascending) a union of their own; returns its slot.
    Slot assign(std::span<const LocalMass> part);
    /// Takes over the label of a received mass. Its motion is not moved.
    void set_received_label(LocalMass m, int label);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void find_planes(VertexSite v);

    std::shared_ptr<const Lattice> lattice_;
    std::vector<std::uint8_t> label_;   ///< by local mass
    std::vector<std::uint8_t> in_use_;  ///< by vertex site: bit p is set where plane p holds an advanced union
};

}  // namespace cracksim::physics
