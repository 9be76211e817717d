#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/block.hpp"
#include "physics/network.hpp"

namespace cracksim::test {

/// A block of unit cubes whose entities are all on one rank.
struct SerialBlock {
    std::array<std::int64_t, 3> cells{3, 3, 3};
    Vec3 edge{1, 1, 1};
    double corner_mass{0.125};
    physics::Elasticity edges{0.2, 0.04};
    physics::Elasticity diagonals{0.3, 0.06};
    physics::Duplets duplets{physics::Duplets::corners};
    physics::Thresholds thresholds{[](Vec3) { return 0.02; }, std::nullopt};
    std::vector<physics::Support> supports{};

    [[nodiscard]] Block block() const { return {cells, edge, {0, 0, 0}}; }
    [[nodiscard]] physics::EntityModel model() const { return {edge, corner_mass, edges, diagonals}; }
    [[nodiscard]] physics::Network network() const {
        std::vector<EntityId> ids;
        for (EntityId e{0}; e.value() < block().entity_count(); ++e) {
            ids.push_back(e);
        }
        const std::size_t count = ids.size();
        return {block(),
                model(),
                IdArray<LocalEntity, EntityId>{std::move(ids)},
                IdArray<LocalEntity, std::uint8_t>(count, 1),
                duplets,
                thresholds,
                supports};
    }
};

}  // namespace cracksim::test
