#include "tests/bench/cgal_map.hpp"

#include "tests/long/flag.hpp"

namespace cracksim::test {

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

template <class Walk>
std::int64_t CgalMap::walk(const Walk& for_each_dart_of) {
    const auto met = map_.get_new_mark();
    std::int64_t sum = 0;
    for (auto dart = map_.darts().begin(); dart != map_.darts().end(); ++dart) {
        if (!map_.is_marked(dart, met)) {
            for_each_dart_of(dart, [&](auto other) {
                map_.mark(other, met);
                sum += map_.info(other);
            });
        }
    }
    map_.free_mark(met);
    return sum;
}

std::int64_t CgalMap::walk_corners() {
    return walk([&](auto dart, const auto& action) {
        auto range = map_.darts_of_orbit<1, 2>(dart);
        for (auto at = range.begin(); at != range.end(); ++at) {
            action(at);
        }
    });
}

std::int64_t CgalMap::walk_vertices() {
    return walk([&](auto dart, const auto& action) {
        auto range = map_.darts_of_orbit<1, 2, 3>(dart);
        for (auto at = range.begin(); at != range.end(); ++at) {
            action(at);
        }
    });
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
