#pragma once

#include "core/block.hpp"
#include "io/summary.hpp"
#include "partition/decomposition.hpp"
#include "partition/partitioner.hpp"
#include "physics/problem/network.hpp"
#include "physics/problem/stability.hpp"
#include "physics/state/state.hpp"
#include "scene/scene.hpp"

namespace cracksim::scene {

/// The step of a scene and the bound that certifies it.
struct CertifiedStep {
    double step;  ///< s
    physics::StepBound bound;
    std::int64_t steps;   ///< to the end of the scene
    std::string warning;  ///< empty: the step keeps the usual distance from the bound
};

/// Throws InputError for a step above the bound unless the scene allows it.
[[nodiscard]] CertifiedStep certify_step(const Scene& scene);

[[nodiscard]] physics::EntityModel entity_model(const Scene& scene);
[[nodiscard]] partition::Partitioner partitioner(const Scene& scene);
[[nodiscard]] physics::Initial initial_fields(const Scene& scene);

[[nodiscard]] io::Summary::Counts scene_counts(const Scene& scene);

/// Throws InputError if the entities are more than the lists of so many ranks can number, however they are shared out.
void check_size(const Block& block, int ranks);
/// Collective. Throws InputError if a rank holds more entities than its lists can number.
void check_size(const partition::Communicator& comm, const partition::Decomposition& decomposition);

/// The network of this rank's entities. Collective: throws InputError on all ranks for a threshold that is not above zero
/// or supports that contradict each other anywhere.
[[nodiscard]] physics::Network build_network(const partition::Communicator& comm, const Scene& scene,
                                             const partition::Decomposition& decomposition);

}  // namespace cracksim::scene
