#include "physics/union_table.hpp"

#include <algorithm>
#include <cstdlib>

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

}  // namespace

UnionTable::UnionTable(const Network& network)
    : stride_{round_up(static_cast<std::size_t>(network.entity_count()) + 1)},
      first_advanced_{static_cast<std::int32_t>(round_up(network.received().size() + 1))},
      end_{first_advanced_},
      batch_runs_(batches(), 0),
      batch_adds_by_corner_(batches(), 0),
      first_mass_(first_advanced_.index()),
      next_mass_(static_cast<std::size_t>(network.mass_count())) {
    const auto void_slot = static_cast<std::int32_t>(network.received().size());
    slot_.assign(stride_ * Hexahedron::corners, void_slot);
    for (std::size_t i = 0; i < network.received().size(); ++i) {
        assign(Slot{static_cast<std::int32_t>(i)}, std::span{network.received()}.subspan(i, 1));
    }
    for (std::size_t u = 0; u < network.union_count(); ++u) {
        assign(add_slot(), network.union_masses(u));
    }
    for (std::size_t batch = 0; batch < batches(); ++batch) {
        update_batch(batch);
    }
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

Slot UnionTable::add_slot() {
    const Slot s = end_;
    if (s.index() == capacity()) {
        first_mass_.resize(first_mass_.size() + lanes);
    }
    ++end_;
    return s;
}

Slot UnionTable::append(std::span<const LocalMass> part) {
    const Slot s = add_slot();
    keep(s, part);
    return s;
}

void UnionTable::keep(Slot s, std::span<const LocalMass> part) {
    assign(s, part);
    for (const LocalMass m : part) {
        update_batch(entity_of(m).index() / lanes);
    }
}

void UnionTable::assign(Slot s, std::span<const LocalMass> part) {
    CRACKSIM_EXPECT(!part.empty() && std::ranges::is_sorted(part));
    first_mass_[s.index()] = part.front();
    for (std::size_t i = 0; i < part.size(); ++i) {
        const LocalMass m = part[i];
        slot_[static_cast<std::size_t>(corner_of(m)) * stride_ + entity_of(m).index()] = s.value();
        next_mass_[m.index()] = i + 1 < part.size() ? part[i + 1] : LocalMass{};
    }
}

void UnionTable::update_batch(std::size_t batch) {
    unsigned runs = 0;
    for (int corner = 0; corner < Hexahedron::corners; ++corner) {
        runs |= is_run(slots_of_corner(corner) + batch * lanes) ? 1U << static_cast<unsigned>(corner) : 0U;
    }
    batch_runs_[batch] = static_cast<std::uint8_t>(runs);
    batch_adds_by_corner_[batch] = runs == 0xffU && adds_by_corner(batch) ? 1 : 0;
}

bool UnionTable::adds_by_corner(std::size_t batch) const {
    const auto base = [&](int corner) { return slots_of_corner(corner)[batch * lanes]; };
    const auto ahead = [&](int first, int last) {
        const int distance = base(first) - base(last);
        return distance > 0 || distance <= -UnionTable::lanes;
    };
    const auto apart = [&](const auto& corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (std::abs(base(corners[i]) - base(corners[j])) < UnionTable::lanes) {
                    return false;
                }
            }
        }
        return true;
    };
    return apart(corners_added_first) && apart(corners_added_last) &&
           std::ranges::all_of(corners_added_first, [&](int first) {
               return std::ranges::all_of(corners_added_last, [&](int last) { return ahead(first, last); });
           });
}

std::size_t UnionTable::memory_bytes() const {
    return slot_.capacity() * sizeof(std::int32_t) + batch_runs_.capacity() + batch_adds_by_corner_.capacity() +
           (first_mass_.capacity() + next_mass_.capacity()) * sizeof(LocalMass);
}

}  // namespace cracksim::physics
