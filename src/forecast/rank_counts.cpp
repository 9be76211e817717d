#include "forecast/rank_counts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/hexahedron.hpp"
#include "physics/problem/lattice.hpp"

namespace cracksim::forecast {

namespace {

/// Ratio of halo entities and received masses of METIS's parts to those of boxes. Measured: 1.00 to 1.29 on 2, 4 and 8
/// ranks, up to 1.56 on 3 ranks, with plates and cubes of 9,000 to 800,000 entities.
constexpr double metis_roughness = 1.15;

/// A rank's part of the block: cells along each axis, and whether the block continues beyond its lower and upper ends
/// (open sides).
struct Box {
    std::array<double, 3> cells;
    std::array<bool, 3> goes_on_below{};
    std::array<bool, 3> goes_on_above{};

    [[nodiscard]] double open_sides(std::size_t axis) const {
        return (goes_on_below[axis] ? 1.0 : 0.0) + (goes_on_above[axis] ? 1.0 : 0.0);
    }
};

std::int64_t whole(double count) { return std::llround(count); }

/// The product over the axes of f(cells, open sides).
double over_axes(const Box& box, auto&& f) {
    return f(box.cells[0], box.open_sides(0)) * f(box.cells[1], box.open_sides(1)) * f(box.cells[2], box.open_sides(2));
}

/// The sum over the axes of along(cells, open sides) times the product over the other two of across(cells, open sides).
double by_axis(const Box& box, auto&& along, auto&& across) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t b = (axis + 1) % 3;
        const std::size_t c = (axis + 2) % 3;
        sum += along(box.cells[axis], box.open_sides(axis)) * across(box.cells[b], box.open_sides(b)) *
               across(box.cells[c], box.open_sides(c));
    }
    return sum;
}

/// Number of sites of a row for its cells or for their vertices (physics/problem/lattice.hpp).
double padded(double cells) {
    constexpr double lanes = physics::Lattice::lanes;
    return (std::floor(cells / lanes) + 1) * lanes;
}

/// Along an axis, n cells have 2n ends, at which the masses are. n owned cells with a halo cell on h sides have
/// 2 (n + h) ends. All of them but the h outer ends are at a vertex of an owned cell and belong to touched unions.
RankCounts counts_of_box(const Box& box, double roughness) {
    const auto with_halo = [](double n, double h) { return n + h; };
    const auto owned_cells = [](double n, double) { return n; };
    const double owned = over_axes(box, owned_cells);
    const double box_local = over_axes(box, with_halo);
    const double local = owned + roughness * (box_local - owned);
    const double box_received = over_axes(box, [](double n, double h) { return 2 * (n + h); }) -
                                over_axes(box, [](double n, double h) { return 2 * n + h; });
    RankCounts counts;
    counts.owned = whole(owned);
    counts.local = whole(local);
    const auto [along, width, height] =
        std::array{with_halo(box.cells[0], box.open_sides(0)), with_halo(box.cells[1], box.open_sides(1)),
                   with_halo(box.cells[2], box.open_sides(2))};
    counts.sites = whole(local / box_local * padded(along) * width * height);
    counts.vertex_sites = whole(local / box_local * padded(along) * (width + 1) * (height + 1));
    counts.interior_faces = whole(local / box_local *
                                  by_axis(
                                      box, [](double n, double h) { return n + h - 1; }, with_halo));
    counts.received = whole(roughness * box_received);
    counts.sent = counts.received;
    counts.sent_unions = whole(roughness * (over_axes(box, [](double n, double h) { return n + h + 1; }) -
                                            over_axes(box, [](double n, double) { return n + 1; })));
    counts.messages = whole(over_axes(box, [](double, double h) { return 1 + h; })) - 1;
    counts.boundary_faces = whole(by_axis(
        box, [](double, double h) { return 2 - h; }, owned_cells));
    return counts;
}

void divide(const Box& box, int ranks, bool along_z_only, std::vector<Box>& parts) {
    if (ranks == 1) {
        parts.push_back(box);
        return;
    }
    const auto longest = static_cast<std::size_t>(std::ranges::max_element(box.cells) - box.cells.begin());
    const std::size_t axis = along_z_only ? 2 : longest;
    const int first_ranks = (ranks + 1) / 2;
    Box first = box;
    Box second = box;
    first.cells[axis] *= static_cast<double>(first_ranks) / ranks;
    second.cells[axis] -= first.cells[axis];
    first.goes_on_above[axis] = true;
    second.goes_on_below[axis] = true;
    divide(first, first_ranks, along_z_only, parts);
    divide(second, ranks - first_ranks, along_z_only, parts);
}

/// The owner of each entity is random. The probability that a rank owns none of the 8 entities around a vertex, or of
/// the 27 entities around an entity, is the product of the probabilities that other ranks own each of them.
RankCounts counts_at_random(const Block& block, int ranks) {
    const double elsewhere = 1 - 1.0 / ranks;
    const double local = static_cast<double>(block.entity_count()) * (1 - std::pow(elsewhere, 27));
    const double touched = 1 - std::pow(elsewhere, 8);
    RankCounts counts;
    counts.owned = block.entity_count() / ranks;
    counts.local = whole(local);
    const auto [nx, ny, nz] = block.cells();
    counts.sites = whole(padded(static_cast<double>(nx))) * ny * nz;
    counts.vertex_sites = whole(padded(static_cast<double>(nx))) * (ny + 1) * (nz + 1);
    counts.interior_faces = block.interior_face_count();
    counts.received = whole((1 - touched) * Hexahedron::corners * local);
    counts.sent = counts.received;
    // At a vertex without owned entities, an entity is local if the rank owns one of the 19 other entities around it.
    const double local_there = Hexahedron::corners * (1 - std::pow(elsewhere, 19));
    const double others = ranks - 1;
    const double owners_there = others * (1 - std::pow(1 - 1 / others, local_there));
    counts.sent_unions = whole((1 - touched) * static_cast<double>(block.vertex_count()) * owners_there);
    counts.messages = ranks - 1;
    counts.boundary_faces = (Hexahedron::faces * block.entity_count() - 2 * block.interior_face_count()) / ranks;
    return counts;
}

}  // namespace

RankCounts count_rank(const dynamics::Dynamics& dynamics, const surface::Coat& coat) {
    const physics::Network& network = dynamics.network();
    RankCounts counts;
    counts.owned = dynamics.decomposition().owned_count();
    counts.local = network.entity_count();
    const physics::Lattice& lattice = dynamics.state().lattice();
    counts.sites = static_cast<std::int64_t>(lattice.batches()) * physics::Lattice::lanes;
    counts.vertex_sites = static_cast<std::int64_t>(lattice.vertex_sites());
    counts.interior_faces = static_cast<std::int64_t>(network.interior_faces().size());
    counts.notched_faces = static_cast<std::int64_t>(network.notched_faces().size());
    counts.received = static_cast<std::int64_t>(network.received().size());
    counts.sent = dynamics.exchange().plan().values_sent();
    counts.sent_unions = dynamics.exchange().unions_sent_at_start();
    counts.messages = static_cast<std::int64_t>(dynamics.exchange().plan().targets().size());
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        for (int face = 0; network.owned(e) && face < Hexahedron::faces; ++face) {
            counts.boundary_faces += coat.map().link(e, face).is_boundary() ? 1 : 0;
        }
    }
    return counts;
}

std::vector<RankCounts> estimated_rank_counts(const Block& block, scene::PartitionKind kind, int ranks) {
    const auto [nx, ny, nz] = block.cells();
    std::vector<RankCounts> counts;
    if (kind == scene::PartitionKind::random && ranks > 1) {
        counts.assign(static_cast<std::size_t>(ranks), counts_at_random(block, ranks));
        return counts;
    }
    std::vector<Box> parts;
    divide({{static_cast<double>(nx), static_cast<double>(ny), static_cast<double>(nz)}}, ranks,
           kind == scene::PartitionKind::slab, parts);
    for (const Box& part : parts) {
        counts.push_back(counts_of_box(part, kind == scene::PartitionKind::metis ? metis_roughness : 1.0));
    }
    return counts;
}

}  // namespace cracksim::forecast
