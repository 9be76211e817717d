#include "physics/standard/standard_engine.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "physics/fracture/opening_faces.hpp"
#include "physics/lattice/advance.hpp"
#include "physics/lattice/next_increments.hpp"
#include "physics/lattice/sum_unions.hpp"
#include "physics/standard/standard_sweep.hpp"

namespace cracksim::physics {

namespace {

/// Calls action(site, entity) for the entities whose bits are set.
void for_each_marked(const Lattice& lattice, std::span<const std::uint8_t> marked, auto&& action) {
    for (std::size_t batch = 0; batch < marked.size(); ++batch) {
        for (unsigned lanes = marked[batch]; lanes != 0; lanes &= lanes - 1) {
            const std::size_t site = batch * Lattice::lanes + static_cast<std::size_t>(std::countr_zero(lanes));
            action(site, lattice.entity(Site{static_cast<std::int32_t>(site)}));
        }
    }
}

}  // namespace

Swept StandardEngine::forces(State& state, Measure measure) {
    state.motion.clear_forces();
    return standard_sweep(*network_, state, caches_, measure).add_all();
}

Swept StandardEngine::advance(State& state, std::span<const Vec3> received, Measure measure) {
    Advancer advancer{*network_, state, caches_.rows, received, measure};
    return advance_and_sweep(advancer, standard_sweep(*network_, state, caches_, measure), state);
}

void StandardEngine::next_increments(const State& state, std::span<const ListedUnions::Entry> unions,
                                     std::span<double> found) const {
    find_next_increments(*network_, state, unions, found);
}

void StandardEngine::corner_forces(const State& state, std::span<const LocalEntity> entities,
                                   std::span<CornerForces> found) const {
    find_standard_corner_forces(*network_, state, entities, found);
}

void StandardEngine::changed(State& state, std::span<const VertexSite> reparted, std::span<const VertexSite> weakened) {
    caches_.rows.update(*network_, state, reparted);
    caches_.set_limits(*network_, state, weakened);
}

// Distances between masses are no part of the sweep over standard entities, so every active duplet counts.
std::vector<LocalDuplet> StandardEngine::may_trigger(const State& state) {
    std::vector<LocalDuplet> all;
    state.active.for_each([&](LocalDuplet d) { all.push_back(d); });
    return all;
}

// The stress that decides about a face is at most the mean of the largest stresses of its two entities
// (fracture/stress_sensor.hpp), so a face opens only if one of them is above the face's threshold: that entity is
// marked.
std::vector<std::int32_t> StandardEngine::opening_faces(const State& state) {
    std::vector<std::int32_t> found;
    std::vector<std::int32_t> unknown;  // faces with an entity whose stress is not stored
    const auto is_marked = [&](std::size_t site) {
        return (unsigned{caches_.stretched[site / Lattice::lanes]} >> site % Lattice::lanes & 1U) != 0;
    };
    for_each_marked(state.lattice(), caches_.stretched, [&](std::size_t site, LocalEntity e) {
        for (int side = 0; side < Hexahedron::faces; ++side) {
            const std::int32_t f = network_->interior_faces().at(e, side);
            if (f < 0 || state.active.of_face(f) == 0) {
                continue;
            }
            const InteriorFace& face = network_->interior_faces()[f];
            const LocalEntity other = face.a == e ? face.b : face.a;
            const std::size_t other_site = state.lattice().site(other).index();
            if (is_marked(other_site) && other < e) {
                continue;  // the other entity decides
            }
            if (!caches_.stresses.is_stored(site) || !caches_.stresses.is_stored(other_site)) {
                unknown.push_back(f);
            } else if (opens(caches_.stresses.of(site), caches_.stresses.of(other_site), side / 2,
                             network_->face_threshold(f))) {
                found.push_back(f);
            }
        }
    });
    const auto others = faces_that_open(*network_, std::move(unknown), [&](std::span<const LocalEntity> entities) {
        return stresses(state, entities);
    });
    found.insert(found.end(), others.begin(), others.end());
    std::ranges::sort(found);
    return found;
}

std::vector<SymmetricTensor> StandardEngine::stresses(const State& state, std::span<const LocalEntity> entities) const {
    return find_standard_stresses(*network_, state, entities);
}

UnionSums StandardEngine::sums(const State& state) const { return sum_unions(*network_, state, caches_.rows.foreign); }

}  // namespace cracksim::physics
