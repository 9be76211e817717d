#pragma once

#include "partition/decomposition.hpp"
#include "partition/partitioner.hpp"
#include "physics/problem/network.hpp"
#include "physics/start.hpp"
#include "scene/scene.hpp"

namespace cracksim::scene {

[[nodiscard]] physics::EntityModel entity_model(const Scene& scene);
[[nodiscard]] partition::Partitioner partitioner(const Scene& scene);
[[nodiscard]] physics::Initial initial_fields(const Scene& scene);

/// Builds the network of this rank's entities. Throws InputError on all ranks if on any rank a threshold is not above
/// zero, supports contradict each other, or initial fields are not finite, and if a notch opens no interior face.
/// Collective.
[[nodiscard]] physics::Network build_network(const partition::Communicator& comm, const Scene& scene,
                                             const partition::Decomposition& decomposition);

}  // namespace cracksim::scene
