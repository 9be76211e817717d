#pragma once

#include <optional>
#include <string>

#include "physics/problem/entity_model.hpp"

namespace cracksim::physics {

/// Describes a number of the sweep that is too large or too small for single precision, with its value; none: all
/// numbers fit. step_size: dt, s.
[[nodiscard]] std::optional<std::string> unfit_for_single_precision(const EntityModel& model, double step_size);

}  // namespace cracksim::physics
