#pragma once

#include "physics/measure.hpp"
#include "physics/standard/sweep/standard_view.hpp"

namespace cracksim::physics {

/// Adds the forces of a row's standard entities to their unions, with the SIMD target in use.
void sweep_row(StandardView<double>& v, const RowView& row, Measure measure);
void sweep_row(StandardView<float>& v, const RowView& row, Measure measure);

/// Computes the forces of gathered entities, with the bits that the sweep of their rows would give.
void sweep_standard_entities(const StandardView<double>& v, GatheredEntities<double>& entities);
void sweep_standard_entities(const StandardView<float>& v, GatheredEntities<float>& entities);

/// Computes the stresses of gathered entities, with the bits that the sweep of their rows would give.
void find_standard_stresses(const StandardView<double>& v, const GatheredEntities<double>& entities,
                            BatchStress& found);
void find_standard_stresses(const StandardView<float>& v, const GatheredEntities<float>& entities, BatchStress& found);

}  // namespace cracksim::physics
