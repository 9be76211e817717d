#include "physics/lattice/loaded_faces.hpp"

#include "physics/lattice/stress_bounds.hpp"
#include "physics/problem/interaction_stress.hpp"

namespace cracksim::physics {

void LoadedFaces::find_bounds(const Network& network, const State& state, const PooledHalves& pooled) {
    const Lattice& lattice = state.lattice();
    bound_.resize(lattice.batches() * Lattice::lanes);
    for (const Lattice::CellRow& row : lattice.cell_rows()) {
        find_stress_bounds(network.model(), row, state.motion, pooled, bound_);
    }
    for (std::size_t half = 0; half < lattice.halves(); ++half) {
        for (std::size_t i = half * Lattice::half; pooled.index()[half] >= 0 && i < (half + 1) * Lattice::half; ++i) {
            const LocalEntity e = lattice.entity(Site{static_cast<std::int32_t>(i)});
            if (e != LocalEntity{}) {
                bound_[i] =
                    stress_bound_with_margin(interaction_stress_bound(network.model(), state.corner_displacements(e)));
            }
        }
    }
}

std::vector<std::int32_t> LoadedFaces::find(const Network& network, const State& state, const PooledHalves& pooled) {
    find_bounds(network, state, pooled);
    const auto bound_of = [&](LocalEntity e) { return static_cast<double>(bound_[state.lattice().site(e).index()]); };
    // One of the two entities of a face that opens has a bound above the lowest threshold.
    const double lowest = network.lowest_threshold();
    std::vector<std::int32_t> found;
    for (std::size_t i = 0; i < bound_.size(); ++i) {
        const bool is_loaded = static_cast<double>(bound_[i]) > lowest;
        const LocalEntity e = is_loaded ? state.lattice().entity(Site{static_cast<std::int32_t>(i)}) : LocalEntity{};
        for (int side = 0; e != LocalEntity{} && side < Hexahedron::faces; ++side) {
            const std::int32_t f = network.interior_faces().at(e, side);
            if (f < 0 || state.active.of_face(f) == 0) {
                continue;
            }
            const InteriorFace& face = network.interior_faces()[f];
            if (bound_of(face.a) + bound_of(face.b) > 2 * network.face_threshold(f)) {
                found.push_back(f);
            }
        }
    }
    return found;
}

}  // namespace cracksim::physics
