#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/ids.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/motion.hpp"

namespace cracksim::physics {

/// The Mass-unions. The masses of a vertex that share a union have the same part number, which follows from the active
/// duplets alone: a lone mass has the number of its corner; the part with the vertex's smallest mass has base_layer;
/// any other part has the corner of its smallest mass. The motion of a union is in the layer of that number. The owner
/// of a received mass sends its part number.
class Unions {
public:
    /// The connected components of masses under active duplets. The unions of received masses count as whole until the
    /// part numbers that their owners send are set.
    Unions(const Network& network, const DupletSet& active);

    [[nodiscard]] const Lattice& lattice() const { return *lattice_; }
    [[nodiscard]] int part(LocalMass m) const { return part_[m.index()]; }
    /// True if the vertex is touched: this rank advances its unions and has all their masses.
    [[nodiscard]] bool is_touched(VertexSite v) const { return in_use_[v.index()] != 0; }
    [[nodiscard]] LocalUnion union_of(LocalMass m) const { return local_union(lattice_->vertex(m), part(m)); }
    /// The smallest local mass of a union; none if the union is empty.
    [[nodiscard]] LocalMass smallest_mass(LocalUnion s) const;
    /// Calls action(mass) for the masses of an advanced union, ascending.
    template <class Action>
    void for_each_mass(LocalUnion s, Action&& action) const {
        lattice_->for_each_mass_at(vertex_of(s), [&](LocalMass m) {
            if (part(m) == layer_of(s)) {
                action(m);
            }
        });
    }
    /// The same masses in a list, which is cleared first.
    void masses(LocalUnion s, std::vector<LocalMass>& found) const;
    [[nodiscard]] int mass_count(LocalUnion s) const;
    /// Calls action(union) for the unions that this rank advances, by vertex and layer.
    template <class Action>
    void for_each_advanced_union(Action&& action) const {
        for (VertexSite v{0}; v.index() < in_use_.size(); ++v) {
            for (unsigned in_use = in_use_[v.index()]; in_use != 0; in_use &= in_use - 1) {
                action(local_union(v, std::countr_zero(in_use)));
            }
        }
    }
    /// The same with each union's smallest mass: action(union, smallest).
    template <class Action>
    void for_each_advanced(Action&& action) const {
        for_each_advanced_union([&](LocalUnion s) { action(s, smallest_of_advanced(s)); });
    }
    /// The smallest mass of an advanced union. It follows from the rule for part numbers, so no part number is read.
    [[nodiscard]] LocalMass smallest_of_advanced(LocalUnion s) const {
        return layer_of(s) == base_layer ? lattice_->smallest_at(vertex_of(s))
                                         : lattice_->mass_at(vertex_of(s), layer_of(s));
    }
    /// All unions that this rank advances, by vertex and layer.
    [[nodiscard]] std::vector<LocalUnion> advanced() const;

    /// Makes some masses of a touched vertex (ascending) a union of their own and returns it.
    LocalUnion assign(std::span<const LocalMass> part);
    /// Sets the part number of a received mass. Does not copy its motion to the new layer.
    void set_received_part(LocalMass m, int part);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void find_layers(VertexSite v);
    void assign_parts(const Network& network, const DupletSet& active, VertexSite v);

    std::shared_ptr<const Lattice> lattice_;
    std::vector<std::uint8_t> part_;    ///< by local mass
    std::vector<std::uint8_t> in_use_;  ///< by vertex site: bit p is set where layer p holds an advanced union
};

}  // namespace cracksim::physics
