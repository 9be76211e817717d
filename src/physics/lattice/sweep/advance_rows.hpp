#pragma once

#include "physics/lattice/sweep/advance_view.hpp"

namespace cracksim::physics {

/// The step of some unions of a row of vertices, with the best SIMD target of the machine.
void advance_layers(AdvanceView<double>& v);
void advance_layers(AdvanceView<float>& v);

/// The next increments of components, with the bits of advance_layers.
void find_next_components(const NextIncrementView<double>& v);
void find_next_components(const NextIncrementView<float>& v);

}  // namespace cracksim::physics
