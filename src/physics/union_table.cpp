#include "physics/union_table.hpp"

#include <algorithm>

#include "core/contracts.hpp"

namespace cracksim::physics {

namespace {

constexpr auto lanes = static_cast<std::size_t>(UnionTable::lanes);

std::size_t round_up(std::size_t n) { return (n + lanes - 1) / lanes * lanes; }

bool is_run(const std::int32_t* values) {
    for (std::int32_t lane = 1; lane < UnionTable::lanes; ++lane) {
        if (values[lane] != values[0] + lane) {
            return false;
        }
    }
    return true;
}

void set_bit(std::uint8_t& byte, int bit, bool value) {
    const auto mask = static_cast<std::uint8_t>(1U << static_cast<unsigned>(bit));
    byte = static_cast<std::uint8_t>(value ? byte | mask : byte & ~mask);
}

}  // namespace

UnionTable::UnionTable(const Network& network)
    : stride_{round_up(static_cast<std::size_t>(network.entity_count()) + 1)},
      first_advanced_{static_cast<std::int32_t>(round_up(network.received().size() + 1))},
      end_{first_advanced_} {
    const auto void_slot = static_cast<std::int32_t>(network.received().size());
    slot_.assign(stride_ * Hexahedron::corners, void_slot);
    for (std::size_t i = 0; i < network.received().size(); ++i) {
        slot_[place(network.received()[i])] = static_cast<std::int32_t>(i);
    }
    for (std::size_t chunk = 0; chunk < first_advanced_.index() / lanes; ++chunk) {
        add_chunk();
    }
    batch_runs_.assign(batches(), 0);
    for (std::size_t u = 0; u < network.union_count(); ++u) {
        append(network.union_masses(u));
    }
    for (std::size_t batch = 0; batch < batches(); ++batch) {
        for (int corner = 0; corner < Hexahedron::corners; ++corner) {
            update_batch(batch, corner);
        }
    }
}

void UnionTable::masses(Slot s, std::vector<LocalMass>& found) const {
    found.clear();
    for (int k = 0; k < mass_count(s); ++k) {
        found.push_back(mass_at(contribution(s, k)));
    }
}

void UnionTable::add_chunk() {
    const auto void_force = static_cast<std::int32_t>(stride_ - 1);
    contributions_.resize(contributions_.size() + max_masses * lanes, void_force);
    chunk_runs_.push_back(0);
    width_.push_back(0);
    mass_count_.resize(mass_count_.size() + lanes, 0);
}

Slot UnionTable::append(std::span<const LocalMass> part) {
    const Slot s = end_;
    if (s.index() == capacity()) {
        add_chunk();
    }
    ++end_;
    assign(s, part);
    return s;
}

void UnionTable::assign(Slot s, std::span<const LocalMass> part) {
    CRACKSIM_EXPECT(!part.empty() && part.size() <= static_cast<std::size_t>(max_masses));
    const auto void_force = static_cast<std::int32_t>(stride_ - 1);
    std::int32_t* list = contributions_.data() + s.index() / lanes * max_masses * lanes + s.index() % lanes;
    for (std::size_t k = 0; k < static_cast<std::size_t>(max_masses); ++k) {
        list[k * lanes] = k < part.size() ? static_cast<std::int32_t>(place(part[k])) : void_force;
    }
    mass_count_[s.index()] = static_cast<std::int8_t>(part.size());
    for (const LocalMass m : part) {
        slot_[place(m)] = s.value();
        update_batch(entity_of(m).index() / lanes, corner_of(m));
    }
    update_chunk(s.index() / lanes);
}

void UnionTable::update_chunk(std::size_t chunk) {
    const auto counts = std::span{mass_count_}.subspan(chunk * lanes, lanes);
    width_[chunk] = static_cast<std::uint8_t>(std::ranges::max(counts));
    for (int k = 0; k < max_masses; ++k) {
        set_bit(chunk_runs_[chunk], k, is_run(contributions(chunk) + k * UnionTable::lanes));
    }
}

void UnionTable::update_batch(std::size_t batch, int corner) {
    set_bit(batch_runs_[batch], corner, is_run(slots_of_corner(corner) + batch * lanes));
}

std::size_t UnionTable::memory_bytes() const {
    return (slot_.capacity() + contributions_.capacity()) * sizeof(std::int32_t) + batch_runs_.capacity() +
           chunk_runs_.capacity() + width_.capacity() + mass_count_.capacity();
}

}  // namespace cracksim::physics
