#include "physics/state/unions.hpp"

#include <algorithm>

#include "core/contracts.hpp"
#include "core/sorted.hpp"
#include "physics/state/parts.hpp"

namespace cracksim::physics {

namespace {

/// The vertices at which an interior face is notched or has an inactive duplet.
std::vector<VertexSite> weakened_vertices(const Network& network, const DupletSet& active) {
    std::vector<VertexSite> vertices;
    const auto add = [&](LocalDuplet d) { vertices.push_back(network.lattice().vertex(network.masses_of(d)[0])); };
    for (const std::int32_t face : network.notched_faces()) {
        for (int k = 0; k < duplets_per_face; ++k) {
            add(local_duplet(face, k));
        }
    }
    network.duplets().for_each([&](LocalDuplet d) {
        if (!active.contains(d)) {
            add(d);
        }
    });
    sort_and_make_unique(vertices);
    return vertices;
}

}  // namespace

Unions::Unions(const Network& network, const DupletSet& active)
    : lattice_{network.shared_lattice()},
      part_(static_cast<std::size_t>(network.mass_count())),
      in_use_(lattice_->vertex_sites(), 0) {
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        const bool alone = network.block().is_corner(network.entity(entity_of(m)), corner_of(m));
        part_[m.index()] = static_cast<std::uint8_t>(alone ? corner_of(m) : base_layer);
    }
    network.for_each_touched_vertex(
        [&](std::span<const LocalMass> masses) { find_layers(lattice_->vertex(masses.front())); });
    for (const VertexSite v : weakened_vertices(network, active)) {
        if (is_touched(v)) {
            assign_parts(network, active, v);
        }
    }
}

void Unions::assign_parts(const Network& network, const DupletSet& active, VertexSite v) {
    std::vector<LocalMass> masses;
    lattice_->for_each_mass_at(v, [&](LocalMass m) { masses.push_back(m); });
    for (const std::vector<LocalMass>& part : connected_parts(network, active, masses)) {
        assign(part);
    }
}

LocalMass Unions::smallest_mass(LocalUnion s) const {
    for (const int corner : Lattice::ascending) {
        const LocalMass m = lattice_->mass_at(vertex_of(s), corner);
        if (m != LocalMass{} && part(m) == layer_of(s)) {
            return m;
        }
    }
    return LocalMass{};
}

void Unions::masses(LocalUnion s, std::vector<LocalMass>& found) const {
    found.clear();
    for_each_mass(s, [&](LocalMass m) { found.push_back(m); });
}

int Unions::mass_count(LocalUnion s) const {
    int count = 0;
    for_each_mass(s, [&](LocalMass) { ++count; });
    return count;
}

std::vector<LocalUnion> Unions::advanced() const {
    std::vector<LocalUnion> all;
    for_each_advanced_union([&](LocalUnion s) { all.push_back(s); });
    return all;
}

void Unions::find_layers(VertexSite v) {
    unsigned in_use = 0;
    lattice_->for_each_mass_at(v, [&](LocalMass m) { in_use |= 1U << static_cast<unsigned>(part(m)); });
    in_use_[v.index()] = static_cast<std::uint8_t>(in_use);
}

LocalUnion Unions::assign(std::span<const LocalMass> part) {
    CRACKSIM_EXPECT(!part.empty() && std::ranges::is_sorted(part));
    const VertexSite v = lattice_->vertex(part.front());
    CRACKSIM_EXPECT(is_touched(v));
    const bool alone = part.size() == 1;
    const int layer = !alone && part.front() == lattice_->smallest_at(v) ? base_layer : corner_of(part.front());
    for (const LocalMass m : part) {
        part_[m.index()] = static_cast<std::uint8_t>(layer);
    }
    find_layers(v);
    return local_union(v, layer);
}

void Unions::set_received_part(LocalMass m, int part) {
    CRACKSIM_EXPECT(!is_touched(lattice_->vertex(m)) && part >= 0 && part < layers);
    part_[m.index()] = static_cast<std::uint8_t>(part);
}

std::size_t Unions::memory_bytes() const { return part_.capacity() + in_use_.capacity(); }

}  // namespace cracksim::physics
