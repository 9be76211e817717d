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

/// The network of this rank's entities. Collective: throws InputError on all ranks for a threshold that is not above zero
/// or supports that contradict each other anywhere,
/// and for a notch that opens no interior face.
[[nodiscard]] physics::Network build_network(const partition::Communicator& comm, const Scene& scene,
                                             const partition::Decomposition& decomposition);

}  // namespace cracksim::scene
