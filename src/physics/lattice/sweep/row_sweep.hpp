#pragma once

#include "physics/lattice/sweep/sweep_view.hpp"

namespace cracksim::physics {

/// The forces of a row's entities onto their unions, with the best SIMD target of the machine.
void sweep_row(SweepView<double>& v, const RowView& row, bool measures_elastic);
void sweep_row(SweepView<float>& v, const RowView& row, bool measures_elastic);

/// The forces of entities gathered from anywhere: the bits that the sweep of their rows finds.
void sweep_entities(const SweepView<double>& v, GatheredEntities<double>& entities);
void sweep_entities(const SweepView<float>& v, GatheredEntities<float>& entities);

}  // namespace cracksim::physics
