#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/vec3.hpp"

namespace cracksim::geometry {

enum class CellKind : std::uint8_t { point = 1, quadrilateral = 9 };  ///< VTK's cell type numbers

/// A field with one value a cell.
struct CellField {
    std::string name;
    std::variant<std::vector<std::int64_t>, std::vector<double>> values;
};

/// A mesh that a frame file contains, distributed over the ranks: each rank holds a contiguous range of the points and
/// a contiguous range of the cells, in rank order. connectivity holds corners() global point numbers for each cell.
struct Mesh {
    CellKind kind{CellKind::quadrilateral};
    std::vector<Vec3> points;  ///< m
    std::vector<std::int64_t> connectivity;
    std::vector<CellField> fields;

    [[nodiscard]] std::int64_t corners() const { return kind == CellKind::point ? 1 : 4; }
    [[nodiscard]] std::int64_t cells() const { return static_cast<std::int64_t>(connectivity.size()) / corners(); }
};

}  // namespace cracksim::geometry
