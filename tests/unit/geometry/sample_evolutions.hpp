#pragma once

#include <cmath>

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "physics/evolution.hpp"

namespace cracksim::geometry::sample {

/// An evolution stored as lists.
struct ListedEvolution final : physics::Evolution {
    explicit ListedEvolution(std::size_t masses) : rest_positions(masses), displacements(masses) {}

    [[nodiscard]] Vec3 rest(LocalMass m) const override { return rest_positions[m]; }
    [[nodiscard]] Vec3 displacement(LocalMass m) const override { return displacements[m]; }

    IdArray<LocalMass, Vec3> rest_positions;
    IdArray<LocalMass, Vec3> displacements;
};

inline ListedEvolution at_rest(const Block& block) {
    ListedEvolution evolution{static_cast<std::size_t>(block.mass_count())};
    for (EntityId e{0}; e.value() < block.entity_count(); ++e) {
        for (int c = 0; c < Hexahedron::corners; ++c) {
            evolution.rest_positions[LocalMass{static_cast<std::int32_t>(mass_id(e, c).value())}] =
                block.position(e, c);
        }
    }
    return evolution;
}

/// Adds a displacement that depends only on the rest position, so that all masses of a vertex stay together.
template <class Field>
void displace(ListedEvolution& evolution, const Field& field) {
    for (std::size_t m = 0; m < evolution.rest_positions.size(); ++m) {
        const LocalMass mass{static_cast<std::int32_t>(m)};
        evolution.displacements[mass] += field(evolution.rest(mass));
    }
}

/// A displacement that twists and bends, so that no face stays plane.
inline Vec3 wavy(Vec3 p) {
    return {0.03 * std::sin(3 * p.y + p.z), 0.05 * std::cos(4 * p.x - p.z), 0.04 * std::sin(5 * p.x * p.y)};
}

}  // namespace cracksim::geometry::sample
