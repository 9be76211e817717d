#include "physics/state/unions.hpp"

#include <algorithm>

#include "core/contracts.hpp"

namespace cracksim::physics {

UnionTable::UnionTable(const Network& network)
    : lattice_{network.shared_lattice()},
      label_(static_cast<std::size_t>(network.mass_count())),
      in_use_(lattice_->vertex_sites(), 0) {
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        const bool alone = network.block().is_corner(network.entity(entity_of(m)), corner_of(m));
        label_[m.index()] = static_cast<std::uint8_t>(alone ? corner_of(m) : base_plane);
    }
    network.for_each_union([&](std::span<const LocalMass> masses) { find_planes(lattice_->vertex(masses.front())); });
}

LocalMass UnionTable::smallest_mass(Slot s) const {
    for (const int corner : Lattice::ascending) {
        const LocalMass m = lattice_->mass_at(vertex_of(s), corner);
        if (m != LocalMass{} && label(m) == plane_of(s)) {
            return m;
        }
    }
    return LocalMass{};
}

void UnionTable::masses(Slot s, std::vector<LocalMass>& found) const {
    found.clear();
    for_each_mass(s, [&](LocalMass m) { found.push_back(m); });
}

int UnionTable::mass_count(Slot s) const {
    int count = 0;
    for_each_mass(s, [&](LocalMass) { ++count; });
    return count;
}

std::vector<Slot> UnionTable::advanced() const {
    std::vector<Slot> all;
    for_each_advanced_slot([&](Slot s) { all.push_back(s); });
    return all;
}

void UnionTable::find_planes(VertexSite v) {
    unsigned in_use = 0;
    lattice_->for_each_mass_at(v, [&](LocalMass m) { in_use |= 1U << static_cast<unsigned>(label(m)); });
    in_use_[v.index()] = static_cast<std::uint8_t>(in_use);
}

Slot UnionTable::assign(std::span<const LocalMass> part) {
    CRACKSIM_EXPECT(!part.empty() && std::ranges::is_sorted(part));
    const VertexSite v = lattice_->vertex(part.front());
    CRACKSIM_EXPECT(is_touched(v));
    const bool alone = part.size() == 1;
    const int plane = !alone && part.front() == lattice_->smallest_at(v) ? base_plane : corner_of(part.front());
    for (const LocalMass m : part) {
        label_[m.index()] = static_cast<std::uint8_t>(plane);
    }
    find_planes(v);
    return slot_of(v, plane);
}

void UnionTable::set_received_label(LocalMass m, int label) {
    CRACKSIM_EXPECT(!is_touched(lattice_->vertex(m)) && label >= 0 && label < planes);
    label_[m.index()] = static_cast<std::uint8_t>(label);
}

std::size_t UnionTable::memory_bytes() const { return label_.capacity() + in_use_.capacity(); }

}  // namespace cracksim::physics
