#pragma once

#include <optional>
#include <string>

#include "physics/problem/entity_model.hpp"

namespace cracksim::physics {

/// Which number of the sweep is too large or too small to be computed with in single precision, and its value; none if all are fit.
/// step_size: dt, s.
[[nodiscard]] std::optional<std::string> unfit_for_single_precision(const EntityModel& model, double step_size);

}  // namespace cracksim::physics
