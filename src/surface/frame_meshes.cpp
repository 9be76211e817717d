#include "surface/frame_meshes.hpp"

#include "geometry/embedding.hpp"
#include "geometry/free_faces.hpp"
#include "geometry/measures.hpp"
#include "topology/dart.hpp"
#include "topology/orbits.hpp"

namespace cracksim::surface {

namespace {

constexpr double shrinking = 0.8;

std::int64_t global_entity(const dynamics::Dynamics& dynamics, LocalEntity e) {
    return dynamics.network().entity(e).value();
}

CellRecord record_of(const dynamics::Dynamics& dynamics, const Coat& coat, const physics::Evolution& evolution,
                     const geometry::FreeFace& face) {
    CellRecord record{};
    record.key = global_entity(dynamics, face.entity) * Hexahedron::faces + face.face;
    record.integers = {global_entity(dynamics, face.entity), coat.fragment(face.entity).value()};
    record.reals = {coat.opened_at(face.entity, face.face),
                    geometry::opening(coat.map(), face, evolution).value_or(0.0)};
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
        record.points[k] = dynamics.network().mass(topology::smallest_corner(coat.map(), face.corners[k])).value();
    }
    return record;
}

}  // namespace

MeshLayout surface_layout(const Block& block) {
    return {geometry::CellKind::quadrilateral,
            block.entity_count(),
            Hexahedron::corners,
            Hexahedron::faces,
            {"entity", "fragment"},
            {"opened_at", "opening"}};
}

MeshLayout mass_layout(const Block& block) {
    return {geometry::CellKind::point, block.entity_count(),   Hexahedron::corners,
            Hexahedron::corners,       {"entity", "fragment"}, {}};
}

MeshLayout topology_layout(const Block& block) {
    return {geometry::CellKind::quadrilateral,
            block.entity_count(),
            std::int64_t{Hexahedron::faces} * Hexahedron::face_corners,
            Hexahedron::faces,
            {"entity", "sewn"},
            {"opened_at"}};
}

geometry::Mesh surface_mesh(const partition::Communicator& comm, const dynamics::Dynamics& dynamics, const Coat& coat,
                            const physics::Evolution& evolution, Faces faces) {
    std::vector<PointRecord> points;
    std::vector<CellRecord> cells;
    for (const geometry::FreeFace& face : geometry::free_faces(coat.map(), dynamics.decomposition().owned.span())) {
        if (faces == Faces::crack_only && !face.is_crack_face) {
            continue;
        }
        cells.push_back(record_of(dynamics, coat, evolution, face));
        for (std::size_t k = 0; k < face.corners.size(); ++k) {
            points.push_back({cells.back().points[k], evolution.position(face.corners[k])});
        }
    }
    return assemble(comm, surface_layout(dynamics.network().block()), points, cells);
}

geometry::Mesh mass_mesh(const partition::Communicator& comm, const dynamics::Dynamics& dynamics, const Coat& coat,
                         const physics::Evolution& evolution) {
    std::vector<PointRecord> points;
    std::vector<CellRecord> cells;
    for (LocalMass m{0}; m.value() < dynamics.network().mass_count(); ++m) {
        const LocalEntity e = entity_of(m);
        if (dynamics.network().owned(e)) {
            const std::int64_t id = dynamics.network().mass(m).value();
            points.push_back({id, evolution.position(m)});
            cells.push_back({id, {id}, {global_entity(dynamics, e), coat.fragment(e).value()}, {}});
        }
    }
    return assemble(comm, mass_layout(dynamics.network().block()), points, cells);
}

geometry::Mesh topology_mesh(const partition::Communicator& comm, const dynamics::Dynamics& dynamics, const Coat& coat,
                             const physics::Evolution& evolution) {
    std::vector<PointRecord> points;
    std::vector<CellRecord> cells;
    for (LocalEntity e{0}; e.value() < dynamics.network().entity_count(); ++e) {
        for (int face = 0; dynamics.network().owned(e) && face < Hexahedron::faces; ++face) {
            const std::int64_t key = global_entity(dynamics, e) * Hexahedron::faces + face;
            CellRecord cell{
                key, {}, {global_entity(dynamics, e), coat.map().is_sewn(e, face) ? 1 : 0}, {coat.opened_at(e, face)}};
            const auto drawn = geometry::shrunk_face(geometry::embed(topology::corners_of(e, face), evolution),
                                                     geometry::entity_centre(e, evolution), shrinking);
            for (std::size_t k = 0; k < drawn.size(); ++k) {
                cell.points[k] = key * Hexahedron::face_corners + static_cast<std::int64_t>(k);
                points.push_back({cell.points[k], drawn[k]});
            }
            cells.push_back(cell);
        }
    }
    return assemble(comm, topology_layout(dynamics.network().block()), points, cells);
}

}  // namespace cracksim::surface
