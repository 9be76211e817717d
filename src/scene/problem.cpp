#include "scene/problem.hpp"

#include <cmath>
#include <limits>

#include "core/errors.hpp"
#include "core/text.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/state/motion.hpp"
#include "physics/problem/single_precision.hpp"
#include "physics/state/held_unions.hpp"
#include "topology/face_link.hpp"

namespace cracksim::scene {

namespace {

Vec3 evaluate(const std::array<io::Expression, 3>& field, Vec3 at) {
    return {field[0](at, 0.0), field[1](at, 0.0), field[2](at, 0.0)};
}

bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

physics::Thresholds thresholds(const Scene& scene) {
    return {[field = scene.sensors.threshold](Vec3 at) { return field(at, 0.0); }, scene.sensors.weibull};
}

std::vector<physics::Support> supports(const Scene& scene) {
    std::vector<physics::Support> all;
    for (const Support& support : scene.supports) {
        physics::Support one{support.name, support.box, {}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (support.velocity[axis]) {
                one.velocity[axis] = [v = *support.velocity[axis]](Vec3 at, double t) { return v(at, t); };
            }
        }
        all.push_back(std::move(one));
    }
    return all;
}

void refuse_above_limit(std::int64_t entities_of_a_rank) {
    constexpr auto most = std::int64_t{topology::FaceLink::entity_limit} - 1;
    if (entities_of_a_rank > most) {
        throw InputError{"block.cells: a rank would hold more than " + std::to_string(most) +
                         " entities; use more ranks"};
    }
}

/// Each rank indexes the vertex sites of its rows along x, times the number of layers, with 32 bits.
void refuse_long_rows(const Block& block, int ranks) {
    // The largest rank may hold a quarter more than the mean.
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max() / physics::layers * std::int64_t{4} / 5;
    const auto [nx, ny, nz] = block.cells();
    const std::int64_t padded = (nx / physics::Lattice::lanes + 1) * physics::Lattice::lanes;
    if (padded * (ny + 1) * (nz + 1) / ranks > most) {
        throw InputError{
            "block.cells: a rank would hold too many rows of so few entities along x; lay the longest side along "
            "x, or use more ranks"};
    }
}

/// In single precision, squares must stay below 1e38.
bool is_fit(Vec3 value, bool single) {
    constexpr double largest = 1e18;
    return is_finite(value) && !(single && norm(value) > largest);
}

/// The first error in this rank's part of the problem, if any.
std::optional<std::string> finding(const physics::Network& network, const Scene& scene) {
    const Places& places = scene.places;
    const physics::Initial initial = initial_fields(scene);
    const bool single = scene.time.precision == physics::Precision::binary32;
    if (network.invalid_threshold()) {
        return places.threshold + *network.invalid_threshold() +
               "; a threshold is a stretch above zero (.inf: never); change the expression so that it is positive "
               "everywhere";
    }
    if (auto conflict = physics::support_conflict(network)) {
        return places.supports + *conflict + "; make the boxes disjoint or leave one component null";
    }
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        const Vec3 at = network.rest_position(m);
        const Vec3 u = initial.displacement(at);
        const Vec3 v = initial.velocity(at);
        const bool fits = is_fit(u, single);
        if (!fits || !is_fit(v, single)) {
            return places.initial + (fits ? "the velocity" : "the displacement") + " at x = " + rounded(at.x, 6) +
                   ", y = " + rounded(at.y, 6) + ", z = " + rounded(at.z, 6) + " m is not a finite number" +
                   (single ? " below 1e18, as time.precision: single needs it" : "") + "; change the expression";
        }
    }
    return std::nullopt;
}

}  // namespace

physics::EntityModel entity_model(const Scene& scene) {
    const auto interaction = [](const Interaction& i) { return physics::KelvinVoigt{i.stiffness, i.viscosity}; };
    return {scene.block.edge(), scene.network.mass, interaction(scene.network.edge), interaction(scene.network.diagonal)};
}

CertifiedStep certify_step(const Scene& scene) {
    const physics::EntityModel model = entity_model(scene);
    const physics::StepBound bound = physics::step_bound(model, scene.time.scheme);
    const double automatic = physics::automatic_step(model, bound);
    const double step = scene.time.step.value_or(automatic);
    constexpr double most_steps = 1e15;
    if (!(scene.time.end / step < most_steps)) {
        throw InputError{scene.places.end + rounded(scene.time.end, 6) + " s takes " +
                         rounded(scene.time.end / step, 6) + " steps of " + rounded(step, 6) +
                         " s, more than can be counted; use an earlier end"};
    }
    if (const auto unfit = scene.time.precision == physics::Precision::binary32
                               ? physics::unfit_for_single_precision(model, step)
                               : std::nullopt) {
        throw InputError{scene.places.precision + "single holds numbers of 1e-25 to 1e25 only, and not " + *unfit +
                         "; use double"};
    }
    CertifiedStep certified{step, bound, static_cast<std::int64_t>(std::ceil(scene.time.end / step * (1 - 1e-12))), ""};
    if (step > bound.step && !scene.time.allow_unstable) {
        throw InputError{scene.places.step + rounded(step, 6) + " s is above the largest stable step " +
                         rounded(bound.step, 6) + " s (set by the " + bound.cause + " of an entity); use at most " +
                         rounded(automatic, 6) + " s or `auto`, or say time.allow_unstable: true"};
    }
    if (step > bound.step) {
        certified.warning = "time.step " + rounded(step, 6) + " s is above the largest stable step " +
                            rounded(bound.step, 6) + " s; the run may blow up (allow_unstable)";
    } else if (step > automatic * (1 + 1e-12)) {
        certified.warning = "time.step " + rounded(step, 6) + " s is stable but closer to the bound " +
                            rounded(bound.step, 6) + " s than the usual " + rounded(automatic, 6) + " s";
    }
    return certified;
}

partition::Partitioner partitioner(const Scene& scene) {
    switch (scene.partition) {
        case PartitionKind::metis: return partition::partition_by_metis;
        case PartitionKind::slab: return partition::partition_by_slabs;
        case PartitionKind::random: return partition::partition_at_random;
    }
    return partition::partition_by_metis;
}

physics::Initial initial_fields(const Scene& scene) {
    return {[field = scene.initial.displacement](Vec3 at) { return evaluate(field, at); },
            [field = scene.initial.velocity](Vec3 at) { return evaluate(field, at); }};
}

io::Summary::Counts scene_counts(const Scene& scene) {
    const Block& block = scene.block;
    constexpr std::int64_t darts_per_face = 2 * Hexahedron::face_corners;
    return {block.entity_count(),
            block.mass_count(),
            block.entity_count() * physics::HexahedronPairs::count,
            scene.duplets == physics::Duplets::tree
                ? block.mass_count() - block.vertex_count()
                : block.interior_face_count() * physics::Network::duplets_per_face,
            block.vertex_count(),
            block.entity_count() * Hexahedron::faces * darts_per_face,
            block.interior_face_count()};
}

void check_size(const Block& block, int ranks) {
    refuse_above_limit((block.entity_count() + ranks - 1) / ranks);
    refuse_long_rows(block, ranks);
}

void check_size(const partition::Communicator& comm, const partition::Decomposition& decomposition) {
    refuse_above_limit(comm.max(static_cast<std::int64_t>(decomposition.entities.size())));
}

physics::Network build_network(const partition::Communicator& comm, const Scene& scene,
                               const partition::Decomposition& decomposition) {
    physics::Network network{scene.block,   entity_model(scene), decomposition.entities, decomposition.owned,
                             scene.duplets, thresholds(scene),   supports(scene)};
    if (const auto text = comm.first(finding(network, scene))) {
        throw InputError{*text};
    }
    return network;
}

}  // namespace cracksim::scene
