#include "physics/lattice/loaded_faces.hpp"

#include "physics/lattice/stress_bounds.hpp"

namespace cracksim::physics {

std::vector<std::int32_t> LoadedFaces::find(const Network& network, const State& state, const PooledHalves& pooled) {
    bound_.resize(state.lattice().batches() * Lattice::lanes);
    find_stress_bounds(network.model(), state.lattice(), state.motion, pooled, bound_);
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
