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

/// The time step of a scene and the stability bound that certifies it.
struct CertifiedStep {
    double step;  ///< s
    physics::StepBound bound;
    std::int64_t steps;   ///< number of steps to the end of the scene
    std::string warning;  ///< empty if the step has the usual safety margin below the bound
};

/// Throws InputError if the step is above the bound, unless the scene allows it.
[[nodiscard]] CertifiedStep certify_step(const Scene& scene);

[[nodiscard]] physics::EntityModel entity_model(const Scene& scene);
[[nodiscard]] partition::Partitioner partitioner(const Scene& scene);
[[nodiscard]] physics::Initial initial_fields(const Scene& scene);

[[nodiscard]] io::Summary::Counts scene_counts(const Scene& scene);

/// Throws InputError if the block has more entities than this number of ranks can index, whatever the partition.
void check_size(const Block& block, int ranks);
/// Throws InputError if a rank holds more entities than it can index. Collective.
void check_size(const partition::Communicator& comm, const partition::Decomposition& decomposition);

/// Builds the network of this rank's entities. Throws InputError on all ranks if on any rank a threshold is not above
/// zero, supports contradict each other, or initial fields are not finite. Collective.
[[nodiscard]] physics::Network build_network(const partition::Communicator& comm, const Scene& scene,
                                             const partition::Decomposition& decomposition);

}  // namespace cracksim::scene
