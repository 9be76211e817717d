#pragma once

#include "core/block.hpp"
#include "geometry/mesh.hpp"
#include "partition/communicator.hpp"
#include "physics/evolution.hpp"
#include "surface/coat.hpp"
#include "dynamics/dynamics.hpp"
#include "surface/mesh_assembly.hpp"

namespace cracksim::surface {

/// What the frames show, at the current state. Each function is collective.

enum class Faces { all_free, crack_only };

/// What the meshes of these functions are and carry.
[[nodiscard]] MeshLayout surface_layout(const Block& block);
[[nodiscard]] MeshLayout mass_layout(const Block& block);
[[nodiscard]] MeshLayout topology_layout(const Block& block);

/// Free faces at the current positions of their corners, one point a topological vertex.
[[nodiscard]] geometry::Mesh surface_mesh(const partition::Communicator& comm, const dynamics::Dynamics& dynamics,
                                          const Coat& coat, const physics::Evolution& evolution, Faces faces);
/// One point a mass.
[[nodiscard]] geometry::Mesh mass_mesh(const partition::Communicator& comm, const dynamics::Dynamics& dynamics, const Coat& coat,
                                       const physics::Evolution& evolution);
/// Every face of every cell, drawn towards its cell's centre, with `sewn`.
[[nodiscard]] geometry::Mesh topology_mesh(const partition::Communicator& comm, const dynamics::Dynamics& dynamics,
                                           const Coat& coat, const physics::Evolution& evolution);

}  // namespace cracksim::surface
