#include "physics/lattice/pooled_corners.hpp"

#include <algorithm>

#include "core/growth.hpp"
#include "core/sorted.hpp"

namespace cracksim::physics {

namespace {

/// Adds one corner of the entities of half a batch, for those entities where it is in the pool.
void add_corner(const Unions& unions, const Motion& motion, std::size_t half, std::size_t corner,
                PooledCorners& found) {
    for (std::size_t lane = 0; lane < Lattice::half; ++lane) {
        const LocalEntity e = unions.lattice().entity(Site{static_cast<std::int32_t>(half * Lattice::half + lane)});
        const PoolPlace place = e == LocalEntity{}
                                    ? PoolPlace{}
                                    : motion.pool_place(unions.union_of(local_mass(e, static_cast<int>(corner))));
        if (place == PoolPlace{}) {
            continue;
        }
        found.place[found.count] = place;
        found.which[found.count] = static_cast<std::uint8_t>(Lattice::half * corner + lane);
        ++found.count;
        found.in_base[corner] = static_cast<std::uint8_t>(found.in_base[corner] & ~(1U << lane));
    }
}

PooledCorners find_in(const Unions& unions, const Motion& motion, std::size_t half) {
    PooledCorners found{};
    found.in_base.fill(PooledCorners::all_lanes);
    for (const auto& [lower, upper] : Lattice::corners_of_side) {
        add_corner(unions, motion, half, upper, found);
        add_corner(unions, motion, half, lower, found);
    }
    return found;
}

}  // namespace

void PooledHalves::find(const Unions& unions, const Motion& motion) {
    halves_.clear();
    std::ranges::fill(index_, -1);
    for (std::size_t half = 0; half < index_.size(); ++half) {
        update_half(unions, motion, half);
    }
}

void PooledHalves::update(const Unions& unions, const Motion& motion, std::span<const VertexSite> vertices) {
    std::vector<std::size_t> halves;
    for (const VertexSite v : vertices) {
        unions.lattice().for_each_mass_at(v, [&](LocalMass m) {
            const std::size_t half = unions.lattice().site(entity_of(m)).index() / Lattice::half;
            if (halves.empty() || half != halves.back()) {
                halves.push_back(half);
            }
        });
    }
    sort_and_make_unique(halves);
    for (const std::size_t half : halves) {
        update_half(unions, motion, half);
    }
}

void PooledHalves::update_half(const Unions& unions, const Motion& motion, std::size_t half) {
    const PooledCorners found = find_in(unions, motion, half);
    std::int32_t& index = index_[half];
    if (index < 0 && found.count > 0) {
        index = static_cast<std::int32_t>(halves_.size());
        make_room(halves_, 1);
        halves_.emplace_back();
    }
    if (index >= 0) {
        halves_[static_cast<std::size_t>(index)] = found;
    }
}

}  // namespace cracksim::physics
