#include "tests/bench/cgal_map.hpp"

#include "tests/long/flag.hpp"

namespace cracksim::test {

namespace {

using Map = CgalMap::Map;

/// A dart of each lower face of a hexahedron, by axis, found from the dart that CGAL returns.
std::array<Map::Dart_handle, 3> lower_darts(Map& map, Map::Dart_handle first) {
    return {first, map.alpha<2>(first), map.alpha<1, 2>(first)};
}

/// The dart of the opposite, upper face that is sewn to the lower face of the neighbour.
Map::Dart_handle opposite(Map& map, Map::Dart_handle lower) { return map.alpha<2, 1, 0, 1, 2>(lower); }

}  // namespace

Map CgalMap::build(const std::array<std::int64_t, 3>& cells) {
    Map map;
    std::vector<std::array<Map::Dart_handle, 3>> lower;
    lower.reserve(static_cast<std::size_t>(cells[0] * cells[1] * cells[2]));
    const std::array<std::int64_t, 3> stride{1, cells[0], cells[0] * cells[1]};
    for (std::int64_t e = 0; e < cells[0] * cells[1] * cells[2]; ++e) {
        lower.push_back(lower_darts(map, map.make_combinatorial_hexahedron()));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (e / stride[axis] % cells[axis] > 0) {
                const auto before = static_cast<std::size_t>(e - stride[axis]);
                map.sew<3>(opposite(map, lower[before][axis]), lower.back()[axis]);
            }
        }
    }
    return map;
}

CgalMap::CgalMap(const std::array<std::int64_t, 3>& cells)
    : map_{CgalBlock{cells}.map()}, upper_(static_cast<std::size_t>(3 * cells[0] * cells[1] * cells[2])) {
    for (auto dart = map_.darts().begin(); dart != map_.darts().end(); ++dart) {
        const Flag flag = flag_of_dart(map_.info(dart));
        if (flag.corner == 1 << flag.face && flag.edge == (flag.face == 0 ? 1 : 0)) {
            upper_[static_cast<std::size_t>(3 * entity_of_dart(map_.info(dart)) + flag.face)] = dart;
        }
    }
}

void CgalMap::unsew(const std::vector<std::int64_t>& faces) {
    for (const std::int64_t face : faces) {
        map_.unsew<3>(upper_[static_cast<std::size_t>(face)]);
    }
}

// The basic iterators mark the darts that they visit, so that no orbit is walked twice.
template <class Walk>
std::int64_t CgalMap::walk(const Walk& darts_of_orbit) {
    const auto met = map_.get_new_mark();
    std::int64_t sum = 0;
    for (auto dart = map_.darts().begin(); dart != map_.darts().end(); ++dart) {
        if (!map_.is_marked(dart, met)) {
            auto orbit = darts_of_orbit(dart, met);
            for (auto at = orbit.begin(); at != orbit.end(); ++at) {
                sum += map_.info(at);
            }
        }
    }
    map_.free_mark(met);
    return sum;
}

std::int64_t CgalMap::walk_corners() {
    return walk([&](auto dart, auto met) { return map_.darts_of_orbit_basic<1, 2>(dart, met); });
}

std::int64_t CgalMap::walk_vertices() {
    return walk([&](auto dart, auto met) { return map_.darts_of_orbit_basic<1, 2, 3>(dart, met); });
}

std::int64_t CgalMap::count_free_faces() const {
    std::int64_t darts = 0;
    for (auto dart = map_.darts().begin(); dart != map_.darts().end(); ++dart) {
        darts += map_.is_free<3>(dart) ? 1 : 0;
    }
    return darts / 8;
}

std::int64_t CgalMap::count_components() { return static_cast<std::int64_t>(map_.count_cells({4})[4]); }

}  // namespace cracksim::test
