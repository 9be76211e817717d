#pragma once

#include <CGAL/Generalized_map.h>

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace cracksim::test {

/// Gives every dart of CGAL's map the name that flag.hpp defines.
struct NamedDarts {
    template <class Map>
    struct Dart_wrapper {
        using Dart_info = std::int64_t;
        using Attributes = std::tuple<>;
    };
};

/// A mass of a union that split. All ids are global; a union's id is its smallest mass.
struct PartedMass {
    std::int64_t step;
    std::int64_t old_union;
    std::int64_t new_union;
    std::int64_t mass;
};

/// A block of hexahedra as CGAL's generalized map, with its own unions, which change by splits only. Shares no code
/// with cracksim: CGAL makes the hexahedra, and this class computes neighbours and corners.
class CgalBlock {
public:
    using Map = CGAL::Generalized_map<3, NamedDarts>;

    /// Sews all faces of neighbouring cells and puts all masses of a vertex in one union. Throws std::logic_error if
    /// CGAL's hexahedron is not a cube.
    explicit CgalBlock(std::array<std::int64_t, 3> cells);

    /// Puts each mass in its new union. The masses must be ordered by step, and within a step by their old union.
    /// Throws std::logic_error if the masses of a split are not exactly those of one union.
    void split(std::span<const PartedMass> masses);
    /// Tests every face of the block and unsews it if two of its corners that coincide are in different unions.
    void unsew_parted_faces();

    [[nodiscard]] const Map& map() const { return map_; }
    /// The name of the dart that alpha_i assigns to a named dart; i = 0 to 3.
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
    /// A dart of the face at an entity's upper end along an axis.
    [[nodiscard]] Dart upper_dart(std::int64_t entity, int axis) const;

    std::array<std::int64_t, 3> cells_;
    Map map_;
    std::vector<Dart> darts_;              ///< by name
    std::vector<std::int64_t> union_of_;   ///< by global mass
    std::vector<std::int64_t> masses_in_;  ///< by union
};

}  // namespace cracksim::test
