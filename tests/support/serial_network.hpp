#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/block.hpp"
#include "physics/problem/network.hpp"

namespace cracksim::test {

/// A block of unit cubes whose entities are all on one rank.
struct SerialBlock {
    std::array<std::int64_t, 3> cells{3, 3, 3};
    Vec3 edge{1, 1, 1};
    double corner_mass{0.125};
    physics::KelvinVoigt edges{0.2, 0.04};
    physics::KelvinVoigt diagonals{0.3, 0.06};
    std::optional<physics::Solid> solid{};  ///< of standard entities; none: entities of the paper's network
    physics::DupletKind duplets{physics::DupletKind::corners};
    physics::SensorKind sensors{physics::SensorKind::normal};
    physics::Thresholds thresholds{[](Vec3) { return 0.02; }, std::nullopt};
    std::vector<physics::Support> supports{};
    std::vector<physics::Notch> notches{};

    [[nodiscard]] Block block() const { return {cells, edge, {0, 0, 0}}; }
    [[nodiscard]] physics::EntityModel model() const {
        return solid ? physics::EntityModel{physics::StandardEntity{*solid, edge}}
                     : physics::EntityModel{edge, corner_mass, edges, diagonals};
    }
    [[nodiscard]] physics::Network network() const { return network_with_halo(0, cells[0]); }
    /// The network of all entities; those with first <= x < last are owned.
    [[nodiscard]] physics::Network network_with_halo(std::int64_t first, std::int64_t last) const {
        std::vector<EntityId> ids;
        std::vector<std::uint8_t> owned;
        for (EntityId e{0}; e.value() < block().entity_count(); ++e) {
            ids.push_back(e);
            const std::int64_t x = e.value() % cells[0];
            owned.push_back(first <= x && x < last ? 1 : 0);
        }
        return physics::Network{{.block = block(),
                                 .model = model(),
                                 .entities = IdArray<LocalEntity, EntityId>{std::move(ids)},
                                 .owned = IdArray<LocalEntity, std::uint8_t>{std::move(owned)},
                                 .duplets = duplets,
                                 .sensors = sensors,
                                 .thresholds = thresholds,
                                 .supports = supports,
                                 .notches = notches}};
    }
};

}  // namespace cracksim::test
