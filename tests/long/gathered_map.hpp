#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulation/simulation.hpp"
#include "tests/long/cgal_block.hpp"
#include "tests/long/flag.hpp"

namespace cracksim::test {

/// What a dart of the cell template stands for, from its face and its edge's two corners: no alpha is asked.
[[nodiscard]] Flag flag_of(int in_cell);

/// An owned entity's dart and where its alphas lead, by name; -1: none.
struct Links {
    std::int64_t dart;
    std::array<std::int64_t, 4> alpha;
};

/// All darts of all ranks' owned entities, on the root. Collective.
[[nodiscard]] std::vector<Links> gather_darts(const simulation::Simulation& s);

/// The splits of all ranks, each once, as CgalBlock takes them, on the root. Collective.
[[nodiscard]] std::vector<PartedMass> gather_splits(const simulation::Simulation& s,
                                                    const physics::SplitStream& splits);

/// Over all ranks. Collective.
[[nodiscard]] std::int64_t free_face_count(const simulation::Simulation& s);
[[nodiscard]] std::int64_t vertex_count(const simulation::Simulation& s);

}  // namespace cracksim::test
