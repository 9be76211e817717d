#include "physics/lattice/shared_edges.hpp"

#include <algorithm>

namespace cracksim::physics {

EdgeCopies edge_copies(const Unions& unions, VertexSite lower, int axis) {
    EdgeCopies found;
    for (const int corner : Lattice::ascending) {
        const LocalMass m = is_lower(corner, axis) ? unions.lattice().mass_at(lower, corner) : LocalMass{};
        if (m != LocalMass{}) {
            const LocalMass other = local_mass(entity_of(m), Hexahedron::across(corner, axis));
            found.copy[found.count++] = {entity_of(m), HexahedronPairs::edge_at(corner, axis), unions.part(m),
                                         unions.part(other)};
        }
    }
    return found;
}

SharedEdges::SharedEdges(const Network& network, const Unions& unions)
    : multiplicity_(unions.lattice().batches() * bytes_per_batch, 0), represented_(unions.lattice().halves(), 0) {
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        multiplicity_[place(unions, e, owned_row)] = network.owned(e) ? 1 : 0;
        for (int i = HexahedronPairs::edges; i < HexahedronPairs::count; ++i) {
            const auto [a, b] = HexahedronPairs::corners[static_cast<std::size_t>(i)];
            const auto felt = [&](int corner) {
                return unions.is_touched(unions.lattice().vertex(local_mass(e, corner)));
            };
            set_multiplicity(unions, e, i, felt(a) || felt(b) ? 1 : 0);
        }
    }
    find_full_halves();
    for (VertexSite v{0}; v.index() < unions.lattice().vertex_sites(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            update_edge(unions, v, axis);
        }
    }
}

void SharedEdges::find_full_halves() {
    for (std::size_t half = 0; half < represented_.size(); ++half) {
        bool all = true;
        for (std::size_t row = HexahedronPairs::edges; row < HexahedronPairs::count; ++row) {
            all = all && all_have(half, row, 1);
        }
        represented_[half] |= all ? 1U << full : 0U;
    }
}

bool SharedEdges::all_have(std::size_t half, std::size_t row, std::uint8_t multiplicity) const {
    const auto lanes = lanes_of(half, row);
    return std::all_of(lanes, lanes + Lattice::half, [&](std::uint8_t w) { return w == multiplicity; });
}

void SharedEdges::find_interior(std::size_t half) {
    constexpr unsigned bit = 1U << interior;
    std::uint32_t& represented = represented_[half];
    represented &= ~bit;
    bool is_interior = represented == (interior_list | 1U << full);
    for (std::size_t row = 0; is_interior && row < rows; ++row) {
        is_interior = all_have(half, row, interior_multiplicities[row]);
    }
    represented |= is_interior ? bit : 0U;
}

void SharedEdges::set_multiplicity(const Unions& unions, LocalEntity e, int interaction, int multiplicity) {
    const auto row = static_cast<std::size_t>(interaction);
    multiplicity_[place(unions, e, row)] = static_cast<std::uint8_t>(multiplicity);
    const std::size_t half = unions.lattice().site(e).index() / Lattice::half;
    const auto lanes = lanes_of(half, row);
    const bool any = std::any_of(lanes, lanes + Lattice::half, [](std::uint8_t w) { return w != 0; });
    const unsigned bit = 1U << row;
    represented_[half] = any ? represented_[half] | bit : represented_[half] & ~bit;
    find_interior(half);
}

void SharedEdges::update_edge(const Unions& unions, VertexSite lower, int axis) {
    const EdgeCopies all = edge_copies(unions, lower, axis);
    if (all.count == 0) {
        return;
    }
    const int upper_corner = HexahedronPairs::corners[static_cast<std::size_t>(all.copy[0].edge)][1];
    const VertexSite upper = unions.lattice().vertex(local_mass(all.copy[0].entity, upper_corner));
    const bool felt = unions.is_touched(lower) || unions.is_touched(upper);
    for (std::size_t i = 0; i < all.count; ++i) {
        int same = 0;
        bool represented_before = false;
        for (std::size_t j = 0; j < all.count; ++j) {
            const bool merged = EdgeCopies::merged(all.copy[i], all.copy[j]);
            same += merged ? 1 : 0;
            represented_before = represented_before || (merged && j < i);
        }
        set_multiplicity(unions, all.copy[i].entity, all.copy[i].edge, felt && !represented_before ? same : 0);
    }
}

void SharedEdges::update(const Unions& unions, VertexSite v) {
    for_each_edge_at(unions.lattice(), v, [&](VertexSite lower, int axis) { update_edge(unions, lower, axis); });
}

}  // namespace cracksim::physics
