#pragma once

#include "physics/lattice/sweep/sweep_view.hpp"

namespace cracksim::physics {

/// Adds the forces of a row's entities to their unions, with the SIMD target in use.
void sweep_row(SweepView<double>& v, const RowView& row, bool measures_elastic);
void sweep_row(SweepView<float>& v, const RowView& row, bool measures_elastic);

/// Computes the forces of gathered entities, with the bits that the sweep of their rows would give to each interaction.
void sweep_entities(const SweepView<double>& v, GatheredEntities<double>& entities);
void sweep_entities(const SweepView<float>& v, GatheredEntities<float>& entities);

}  // namespace cracksim::physics
