#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/long/cgal_block.hpp"

namespace cracksim::test {

/// CGAL's counterpart of the operations that map.cpp measures. A face is named by the entity and the axis whose upper
/// face it is.
class CgalMap {
public:
    using Map = CgalBlock::Map;

    explicit CgalMap(const std::array<std::int64_t, 3>& cells);

    /// Builds the block without names of darts: hexahedra, and their sewn faces.
    [[nodiscard]] static Map build(const std::array<std::int64_t, 3>& cells);

    void unsew(const std::vector<std::int64_t>& faces);
    /// Sums over all darts, visited by volume corners or by vertices.
    [[nodiscard]] std::int64_t walk_corners();
    [[nodiscard]] std::int64_t walk_vertices();
    [[nodiscard]] std::int64_t count_free_faces() const;
    [[nodiscard]] bool is_valid() const { return map_.is_valid(); }
    [[nodiscard]] std::int64_t count_components();
    [[nodiscard]] std::size_t bytes() const { return map_.bytes(); }

private:
    template <class Walk>
    std::int64_t walk(const Walk& darts_of_orbit);

    Map map_;
    std::vector<Map::Dart_handle> upper_;  ///< by 3 * entity + axis
};

}  // namespace cracksim::test
