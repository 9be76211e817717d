#include "tests/bench/damaged_block.hpp"

#include <random>

#include "core/block.hpp"

namespace cracksim::test {

namespace {

using physics::HexahedronPairs;
using physics::LocalDuplet;

// Flops of an interaction in interaction-inl.hpp: differences of u and w 6, quadratic strain 8 (diagonal 12),
// SeriesRatios 22, dw.d 5, drag 3, multiplicity (k g + drag) 3, dissipation 3, range 1, and the two sums of forces 12.
constexpr double flops_of_edge = 63;
constexpr double flops_of_diagonal = 67;
// The first contribution to each of the 8 corners needs no sum (-24), the corners' forces are added to the unions (24),
// dissipation (2). Computations for edges that another entity represents (multiplicity 0) do not count.
constexpr double flops_of_entity = 2;
// w + F dt^2/M and u + w; with ab2 also 1.5 w - 0.5 w.
constexpr double flops_of_union = 9;
constexpr double flops_of_extrapolation = 9;

}  // namespace

std::vector<LocalDuplet> parting_duplets(const physics::Network& network, double share, std::uint64_t seed) {
    const physics::Lattice& lattice = network.lattice();
    std::mt19937_64 random{seed};
    std::bernoulli_distribution parts{share};
    std::vector<int> axis_at(lattice.vertex_sites());
    for (int& axis : axis_at) {
        axis = parts(random) ? static_cast<int>(random() % 3) : -1;
    }
    std::vector<LocalDuplet> found;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(network.interior_faces().size()); ++i) {
        const physics::InteriorFace& shared = network.interior_faces()[i];
        for (int k = 0; k < physics::duplets_per_face; ++k) {
            const auto v = lattice.vertex(local_mass(shared.a, shared.corner_a(k)));
            if (share == 1 || axis_at[v.index()] == shared.face_a / 2) {
                found.emplace_back(i * physics::duplets_per_face + k);
            }
        }
    }
    return found;
}

double flops_of_step(const DamagedBlock& block) {
    const physics::State& state = block.body.state;
    const physics::LatticeCaches& caches = block.body.engine.caches();
    double flops = flops_of_entity * block.network.entity_count();
    for (LocalEntity e{0}; e.value() < block.network.entity_count(); ++e) {
        for (int i = 0; i < HexahedronPairs::count; ++i) {
            if (caches.shared_edges.multiplicity(state.unions, e, i) > 0) {
                flops += i < HexahedronPairs::edges ? flops_of_edge : flops_of_diagonal;
            }
        }
    }
    const bool extrapolates = state.scheme == physics::Scheme::ab2;
    return flops + (flops_of_union + (extrapolates ? flops_of_extrapolation : 0)) *
                       static_cast<double>(state.unions.advanced().size());
}

double bytes_of_step(const DamagedBlock& block) {
    const physics::State& state = block.body.state;
    const physics::LatticeCaches& caches = block.body.engine.caches();
    // All of the 10 components (13 with ab2) are read and all but dt^2/M are written. memory_bytes also counts the
    // lists of the pool, which are small in comparison.
    const double components = state.scheme == physics::Scheme::ab2 ? 13 : 10;
    const double motion = static_cast<double>(state.motion.memory_bytes()) * (2 * components - 1) / components;
    const std::size_t read = caches.shared_edges.memory_bytes() + caches.rows.pooled.memory_bytes() +
                             caches.limits.memory_bytes() + caches.exceeded.size() * sizeof(physics::EdgeBits);
    return motion + static_cast<double>(read);
}

}  // namespace cracksim::test
