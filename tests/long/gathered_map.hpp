#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulation/simulation.hpp"
#include "tests/long/cgal_block.hpp"
#include "tests/long/flag.hpp"

namespace cracksim::test {

/// The flag that a dart of the cell template stands for, from its face and its edge's two corners, without any alpha.
[[nodiscard]] Flag flag_of(int in_cell);

/// A dart of an owned entity and the names of the darts to which its alphas lead; -1: none.
struct Links {
    std::int64_t dart;
    std::array<std::int64_t, 4> alpha;
};

/// All darts of the owned entities of all ranks, on the root. Collective.
[[nodiscard]] std::vector<Links> gather_darts(const simulation::Simulation& s);

/// The splits of all ranks, each once, in the form that CgalBlock takes, on the root. Collective.
[[nodiscard]] std::vector<PartedMass> gather_splits(const simulation::Simulation& s,
                                                    const physics::SplitStream& splits);

/// The number of free faces over all ranks. Collective.
[[nodiscard]] std::int64_t free_face_count(const simulation::Simulation& s);
[[nodiscard]] std::int64_t vertex_count(const simulation::Simulation& s);

}  // namespace cracksim::test
