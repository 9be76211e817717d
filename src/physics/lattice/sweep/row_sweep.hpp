#pragma once

#include "physics/lattice/sweep/sweep_view.hpp"
#include "physics/measure.hpp"

namespace cracksim::physics {

/// Adds the forces of a row's entities to their unions, with the SIMD target in use.
void sweep_row(SweepView<double>& v, const RowView& row, Measure measure);
void sweep_row(SweepView<float>& v, const RowView& row, Measure measure);

/// Computes the forces of gathered entities, with the bits that the sweep of their rows would give to each interaction.
void sweep_entities(const SweepView<double>& v, GatheredEntities<double>& entities);
void sweep_entities(const SweepView<float>& v, GatheredEntities<float>& entities);

}  // namespace cracksim::physics
