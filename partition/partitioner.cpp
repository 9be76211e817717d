#include "partition/partitioner.hpp"

#include <metis.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "core/hash.hpp"

namespace cracksim::partition {

namespace {

struct Graph {
    std::vector<idx_t> offsets{0};
    std::vector<idx_t> neighbours;
};

Graph graph_of(const Block& block) {
    if (const auto refusal = metis_refusal(block)) {
        throw std::runtime_error{*refusal};
    }
    Graph graph;
    for (EntityId e{0}; e.value() < block.entity_count(); ++e) {
        for (int face = 0; face < Hexahedron::faces; ++face) {
            if (const auto other = block.neighbour(e, face)) {
                graph.neighbours.push_back(static_cast<idx_t>(other->entity.value()));
            }
        }
        graph.offsets.push_back(static_cast<idx_t>(graph.neighbours.size()));
    }
    return graph;
}

std::vector<Rank> from_each_entity(const Block& block, auto&& rank_of) {
    std::vector<Rank> owner(static_cast<std::size_t>(block.entity_count()));
    for (std::size_t e = 0; e < owner.size(); ++e) {
        owner[e] = Rank{static_cast<std::int32_t>(rank_of(static_cast<std::int64_t>(e)))};
    }
    return owner;
}

}  // namespace

std::optional<std::string> metis_refusal(const Block& block) {
    if (block.entity_count() <= std::numeric_limits<idx_t>::max() / Hexahedron::faces) {
        return std::nullopt;
    }
    return "the block is too large for METIS with 32-bit indices; use partition.kind: slab";
}

std::vector<Rank> partition_by_metis(const Block& block, int ranks) {
    if (ranks == 1 || block.entity_count() <= ranks) {
        return partition_by_slabs(block, ranks);
    }
    Graph graph = graph_of(block);
    auto entities = static_cast<idx_t>(block.entity_count());
    idx_t constraints = 1;
    idx_t parts = ranks;
    idx_t cut = 0;
    std::vector<idx_t> part(static_cast<std::size_t>(entities));
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    const int outcome =
        METIS_PartGraphRecursive(&entities, &constraints, graph.offsets.data(), graph.neighbours.data(), nullptr,
                                 nullptr, nullptr, &parts, nullptr, nullptr, options, &cut, part.data());
    if (outcome != METIS_OK) {
        throw std::runtime_error{"METIS could not partition the block (code " + std::to_string(outcome) +
                                 "); use partition.kind: slab"};
    }
    return from_each_entity(block, [&](std::int64_t e) { return part[static_cast<std::size_t>(e)]; });
}

std::vector<Rank> partition_by_slabs(const Block& block, int ranks) {
    const std::int64_t entities = block.entity_count();
    return from_each_entity(block, [&](std::int64_t e) { return entities <= ranks ? e : e * ranks / entities; });
}

std::vector<Rank> partition_at_random(const Block& block, int ranks) {
    return from_each_entity(
        block, [&](std::int64_t e) { return mix(static_cast<std::uint64_t>(e)) % static_cast<std::uint64_t>(ranks); });
}

}  // namespace cracksim::partition
