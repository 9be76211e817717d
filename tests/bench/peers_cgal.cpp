// CGAL's generalized map of a block: build and sew, walks, unsew. Rows of the table of tests/bench/run.sh.
#include <CGAL/Generalized_map.h>
#include <CGAL/version.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

using Map = CGAL::Generalized_map<3>;
using Dart = Map::Dart_handle;
using Clock = std::chrono::steady_clock;

constexpr int rounds = 5;

/// Darts of a hexahedron's faces: on each of the six, the one whose vertex and edge are those of the neighbour's face that it meets.
struct Faces {
    std::array<Dart, 3> lower;
    std::array<Dart, 3> upper;
};

/// A dart of the next face around: over the edge, along it, and on.
Dart on_opposite_face(Map& map, Dart dart) { return map.alpha<2, 1, 0, 1, 2>(dart); }

/// On the first face, on one beside it, and on the third that meets both; each with its opposite.
Faces faces_of(Map& map, Dart first) {
    const std::array<Dart, 3> lower{first, map.alpha<2>(first), map.alpha<1, 2>(first)};
    Faces faces{lower, {}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        faces.upper[axis] = on_opposite_face(map, lower[axis]);
    }
    return faces;
}

struct Block {
    std::array<std::size_t, 3> cells;
    Map map{};
    std::vector<Faces> faces{};
    std::vector<Dart> sewn{};

    explicit Block(std::array<std::size_t, 3> size) : cells{size} {
        for (std::size_t e = 0; e < cells[0] * cells[1] * cells[2]; ++e) {
            faces.push_back(faces_of(map, map.make_combinatorial_hexahedron()));
        }
        std::size_t stride = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t e = 0; e + stride < faces.size(); ++e) {
                if (e / stride % cells[axis] + 1 < cells[axis]) {
                    map.sew<3>(faces[e].upper[axis], faces[e + stride].lower[axis]);
                    sewn.push_back(faces[e].upper[axis]);
                }
            }
            stride *= cells[axis];
        }
    }
};

double seconds_of(const std::function<void()>& action) {
    const auto start = Clock::now();
    action();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void print_row(const char* name, std::vector<double> values, const char* unit, const std::string& remark) {
    std::ranges::sort(values);
    std::printf("CGAL %s generalized map\t%s\t%.4g\t%.4g\t%.4g\t%s\t%s\n", CGAL_VERSION_STR, name,
                values[values.size() / 2], values.front(), values.back(), unit, remark.c_str());
}

/// Darts that the orbits of all darts not seen before have; as one walks all cells.
template <unsigned... alphas>
std::size_t walk(Map& map) {
    const auto mark = map.get_new_mark();
    std::size_t visited = 0;
    for (auto dart = map.darts().begin(); dart != map.darts().end(); ++dart) {
        if (map.is_marked(dart, mark)) {
            continue;
        }
        for (auto other = map.darts_of_orbit<alphas...>(dart).begin(); other.cont(); ++other) {
            map.mark(other, mark);
            ++visited;
        }
    }
    map.free_mark(mark);
    return visited;
}

struct Samples {
    std::vector<double> build, corners, vertices, unsew;
};

void measure_once(std::array<std::size_t, 3> cells, Samples& samples, std::uint64_t seed) {
    std::unique_ptr<Block> block;
    samples.build.push_back(1e3 * seconds_of([&] { block = std::make_unique<Block>(cells); }));
    std::size_t darts = 0;
    const double corner_seconds = seconds_of([&] { darts = walk<1, 2>(block->map); });
    samples.corners.push_back(1e-6 * static_cast<double>(darts) / corner_seconds);
    const double vertex_seconds = seconds_of([&] { darts = walk<1, 2, 3>(block->map); });
    samples.vertices.push_back(1e-6 * static_cast<double>(darts) / vertex_seconds);
    std::shuffle(block->sewn.begin(), block->sewn.end(), std::mt19937_64{seed});
    const double unsew_seconds = seconds_of([&] {
        for (const Dart dart : block->sewn) {
            block->map.unsew<3>(dart);
        }
    });
    samples.unsew.push_back(1e-6 * static_cast<double>(block->sewn.size()) / unsew_seconds);
}

/// The sewing must be that of a block: as many vertices as it has, one component. Returns bytes a hexahedron.
double check_and_weigh(std::array<std::size_t, 3> cells) {
    const Block block{cells};
    const auto counts = block.map.count_cells({0, 4});
    if (counts[0] != (cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1) || counts[4] != 1 || !block.map.is_valid()) {
        std::fprintf(stderr, "CGAL's map is not that of a block: %zu vertices, %zu components\n",
                     static_cast<std::size_t>(counts[0]), static_cast<std::size_t>(counts[4]));
        std::exit(1);
    }
    return static_cast<double>(block.map.bytes()) / static_cast<double>(block.faces.size());
}

}  // namespace

int main(int argc, char**) {
    const bool quick = argc > 1;
    const std::array<std::size_t, 3> cells =
        quick ? std::array<std::size_t, 3>{14, 14, 5} : std::array<std::size_t, 3>{70, 70, 10};
    const double bytes = check_and_weigh(cells);
    Samples samples;
    for (std::uint64_t round = 0; round < (quick ? 1 : rounds); ++round) {
        measure_once(cells, samples, round);
    }
    print_row("memory", {bytes}, "bytes/hexahedron", "");
    print_row("build and sew", samples.build, "ms", "block of " + std::to_string(cells[0] * cells[1] * cells[2]));
    print_row("walk volume corners <1,2>", samples.corners, "M darts/s", "with marks");
    print_row("walk vertices <1,2,3>", samples.vertices, "M darts/s", "with marks");
    print_row("unsew, random order", samples.unsew, "M faces/s", "");
}
