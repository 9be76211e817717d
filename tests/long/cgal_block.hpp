#pragma once

#include <CGAL/Generalized_map.h>

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace cracksim::test {

/// Every dart carries its name (flag.hpp).
struct NamedDarts {
    template <class Map>
    struct Dart_wrapper {
        using Dart_info = std::int64_t;
        using Attributes = std::tuple<>;
    };
};

/// A mass of a split. All ids are global; a union's id is its smallest mass.
struct PartedMass {
    std::int64_t step;
    std::int64_t old_union;
    std::int64_t new_union;
    std::int64_t mass;
};

/// A block of hexahedra as CGAL's generalized map, with unions of its own that know of splits only. Shares no code with
/// cracksim: hexahedra are CGAL's, neighbours and corners are counted here.
class CgalBlock {
public:
    using Map = CGAL::Generalized_map<3, NamedDarts>;

    /// All faces of neighbouring cells sewn, all masses of a vertex in one union. Throws std::logic_error if CGAL's
    /// hexahedron is not a cube.
    explicit CgalBlock(std::array<std::int64_t, 3> cells);

    /// Puts each mass in its new union. Ordered by step, and within a step by the old union. Throws std::logic_error if
    /// the masses of a split are not exactly those of one union.
    void split(std::span<const PartedMass> masses);
    /// Unsews each face of which two corners that meet are in different unions; by a look at every face of the block.
    void unsew_parted_faces();

    [[nodiscard]] const Map& map() const { return map_; }
    /// Where alpha_i leads, by names; i = 0 to 3.
    [[nodiscard]] std::int64_t alpha(int i, std::int64_t dart) const;
    [[nodiscard]] std::int64_t free_face_count() const;
    [[nodiscard]] std::int64_t vertex_count() const;
    [[nodiscard]] std::int64_t component_count() const;

private:
    using Dart = Map::Dart_handle;

    void make_hexahedron(std::int64_t entity);
    void split_one(std::span<const PartedMass> masses);
    void name_from(Dart dart, std::int64_t name);
    void start_unions();
    [[nodiscard]] std::int64_t upper_neighbour(std::int64_t entity, int axis) const;
    [[nodiscard]] std::int64_t vertex(std::int64_t entity, int corner) const;
    [[nodiscard]] bool shares_unions(std::int64_t lower, std::int64_t upper, int axis) const;
    [[nodiscard]] Dart dart(std::int64_t name) const { return darts_[static_cast<std::size_t>(name)]; }
    /// A dart of an entity's face at the upper end of an axis.
    [[nodiscard]] Dart upper_dart(std::int64_t entity, int axis) const;

    std::array<std::int64_t, 3> cells_;
    Map map_;
    std::vector<Dart> darts_;              ///< by name
    std::vector<std::int64_t> union_of_;   ///< by global mass
    std::vector<std::int64_t> masses_in_;  ///< by union
};

}  // namespace cracksim::test
