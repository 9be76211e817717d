#pragma once

#include <cstdint>

namespace cracksim::physics {

/// What a sweep adds up beside the dissipation at its state: nothing, the elastic energy, or that and the dissipation
/// over the last step (Swept::over_step). The forces have the same bits.
enum class Measure : std::uint8_t { nothing, elastic_energy, all };

}  // namespace cracksim::physics
