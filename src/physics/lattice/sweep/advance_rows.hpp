#pragma once

#include "physics/lattice/sweep/advance_view.hpp"

namespace cracksim::physics {

/// Advances some unions of a row of vertices by one step, with the SIMD target in use.
void advance_layers(AdvanceView<double>& v);
void advance_layers(AdvanceView<float>& v);

/// Computes the increments that advance_layers would give to some components, bit for bit.
void find_next_components(const NextIncrementView<double>& v);
void find_next_components(const NextIncrementView<float>& v);

}  // namespace cracksim::physics
