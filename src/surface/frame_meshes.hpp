#pragma once

#include "core/block.hpp"
#include "dynamics/dynamics.hpp"
#include "geometry/mesh.hpp"
#include "partition/communicator.hpp"
#include "physics/evolution.hpp"
#include "surface/coat.hpp"
#include "surface/mesh_assembly.hpp"

namespace cracksim::surface {

// The meshes of the frames at the current state. The functions that return a mesh are collective.

enum class Faces { all_free, crack_only };

/// The layouts of the meshes that the functions below return. GatheredSurface has the same fields as surface_layout.
[[nodiscard]] MeshLayout surface_layout(const Block& block);
[[nodiscard]] MeshLayout mass_layout(const Block& block);
[[nodiscard]] MeshLayout topology_layout(const Block& block);

/// Free faces at the current positions of their corners; each topological vertex is one point.
[[nodiscard]] geometry::Mesh surface_mesh(const partition::Communicator& comm, const dynamics::Dynamics& dynamics,
                                          const Coat& coat, const physics::Evolution& evolution, Faces faces);
/// One point for each mass.
[[nodiscard]] geometry::Mesh mass_mesh(const partition::Communicator& comm, const dynamics::Dynamics& dynamics,
                                       const Coat& coat, const physics::Evolution& evolution);
/// All faces of all entities, each shrunk towards its entity's centre, with the field `sewn`.
[[nodiscard]] geometry::Mesh topology_mesh(const partition::Communicator& comm, const dynamics::Dynamics& dynamics,
                                           const Coat& coat, const physics::Evolution& evolution);

}  // namespace cracksim::surface
