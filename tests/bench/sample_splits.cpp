#include "tests/bench/sample_splits.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <random>

#include "core/contracts.hpp"

namespace cracksim::test {
namespace {

/// True if the entities of a set are connected by faces. Bit k of the set stands for the entity, of the 8 around a
/// vertex, that is on the upper side along the axes whose bits k has.
bool hangs_together(unsigned set) {
    unsigned reached = set & (~set + 1);
    for (unsigned before = 0; before != reached;) {
        before = reached;
        for (unsigned k = 0; k < 8; ++k) {
            for (unsigned axis = 1; (reached >> k & 1U) != 0 && axis < 8; axis *= 2) {
                reached |= set & 1U << (k ^ axis);
            }
        }
    }
    return reached == set;
}

/// The sets with `size` entities that are connected by faces and whose complement is connected too.
std::vector<unsigned> sets_of(int size) {
    std::vector<unsigned> sets;
    for (unsigned set = 1; set < 255; ++set) {
        if (std::popcount(set) == size && hangs_together(set) && hangs_together(255U ^ set)) {
            sets.push_back(set);
        }
    }
    return sets;
}

/// The shuffled vertices inside the cube of entities from `first` to `first + side` along each axis.
std::vector<VertexId> vertices_inside(const Block& block, std::int64_t first, std::int64_t side,
                                      std::mt19937_64& random) {
    std::vector<VertexId> vertices;
    const std::int64_t row = block.cells()[0] + 1;
    for (std::int64_t z = first + 1; z < first + side; ++z) {
        for (std::int64_t y = first + 1; y < first + side; ++y) {
            for (std::int64_t x = first + 1; x < first + side; ++x) {
                vertices.emplace_back(x + row * (y + row * z));
            }
        }
    }
    std::shuffle(vertices.begin(), vertices.end(), random);
    return vertices;
}

LocalMass mass_at(const Block& block, EntityId entity, VertexId vertex) {
    int corner = 0;
    while (block.vertex(entity, corner) != vertex) {
        ++corner;
    }
    return local_mass(LocalEntity{static_cast<std::int32_t>(entity.value())}, corner);
}

std::array<std::vector<LocalMass>, 2> parts_at(const Block& block, VertexId vertex, unsigned set) {
    std::array<std::vector<LocalMass>, 2> parts;
    unsigned k = 0;
    for (const EntityId entity : block.around(vertex)) {
        parts[set >> k++ & 1U].push_back(mass_at(block, entity, vertex));
    }
    std::sort(parts.begin(), parts.end());
    return parts;
}

}  // namespace

physics::SplitStream sample_splits(const Block& block, Place place, std::size_t count, int masses, std::uint64_t seed) {
    const std::int64_t side = place == Place::whole_block ? block.cells()[0] : middle_side;
    std::mt19937_64 random{seed};
    const auto vertices = vertices_inside(block, (block.cells()[0] - side) / 2, side, random);
    CRACKSIM_EXPECT(count <= vertices.size());
    std::array<std::vector<unsigned>, 8> sets;
    for (int size = 1; size < 8; ++size) {
        sets[static_cast<std::size_t>(size)] = sets_of(size);
    }
    physics::SplitStream splits;
    for (std::size_t n = 0; n < count; ++n) {
        const auto& of_size = sets[masses > 0 ? static_cast<std::size_t>(masses) : 1 + n % 7];
        splits.begin_split(static_cast<std::int64_t>(n), 1e-3 * static_cast<double>(n));
        for (const auto& part : parts_at(block, vertices[n], of_size[random() % of_size.size()])) {
            splits.add_part(part);
        }
    }
    return splits;
}

}  // namespace cracksim::test
