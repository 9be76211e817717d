#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/mesh.hpp"
#include "partition/communicator.hpp"

namespace cracksim::io {

/// The items [begin, end) of `count` that a rank of `ranks` holds; shares are unequal, and some are empty if `count` is
/// small.
struct Share {
    std::int64_t begin;
    std::int64_t end;
};
inline Share share(std::int64_t count, std::int64_t rank, std::int64_t ranks) {
    return {count * rank * rank / (ranks * ranks), count * (rank + 1) * (rank + 1) / (ranks * ranks)};
}

/// A strip of `cells` unit squares along x, bent by `lift` in z; its points and cells are distributed over the ranks.
inline geometry::Mesh strip_mesh(const partition::Communicator& comm, std::int64_t cells, double lift) {
    geometry::Mesh mesh;
    const Share columns = share(cells == 0 ? 0 : cells + 1, comm.rank().value(), comm.size());
    for (std::int64_t column = columns.begin; column < columns.end; ++column) {
        const auto x = static_cast<double>(column);
        mesh.points.push_back({x, 0, lift * x * x});
        mesh.points.push_back({x, 1, lift * x * x});
    }
    std::vector<std::int64_t> entity;
    std::vector<double> opening;
    const Share own = share(cells, comm.rank().value(), comm.size());
    for (std::int64_t cell = own.begin; cell < own.end; ++cell) {
        const std::int64_t p = 2 * cell;
        mesh.connectivity.insert(mesh.connectivity.end(), {p, p + 2, p + 3, p + 1});
        entity.push_back(1000 + cell);
        opening.push_back(0.1 * static_cast<double>(cell));
    }
    mesh.fields = {{"entity", entity}, {"opening", opening}};
    return mesh;
}

/// Points along x with one field; each point is a cell.
inline geometry::Mesh point_mesh(const partition::Communicator& comm, std::int64_t points) {
    geometry::Mesh mesh{.kind = geometry::CellKind::point, .points = {}, .connectivity = {}, .fields = {}};
    std::vector<double> speed;
    const Share own = share(points, comm.rank().value(), comm.size());
    for (std::int64_t point = own.begin; point < own.end; ++point) {
        mesh.points.push_back({static_cast<double>(point), 0.5, -1});
        mesh.connectivity.push_back(point);
        speed.push_back(static_cast<double>(point));
    }
    mesh.fields = {{"speed", speed}};
    return mesh;
}

}  // namespace cracksim::io
