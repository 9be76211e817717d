#pragma once

#include <string>

#include "core/block.hpp"
#include "physics/problem/sensor_kind.hpp"
#include "scene/scene.hpp"

namespace cracksim::scene {

/// The threshold for which a crack along the grid has the fracture energy G_c of a material: s_c = sqrt(G_c / (c E a)).
/// The constant c depends on the entity, the sensors and Poisson's ratio; it is measured on strips with a crack along
/// the grid, loaded slowly between fixed grips (tests/verification/fracture_constants.py), and extrapolated to strips
/// that are high compared with an edge. Between two measured ratios it is interpolated linearly.
///
/// Throws InputError at `where` (the beginning of a message), naming the nearest that is measured, if it is not.
[[nodiscard]] double calibrated_threshold(const Material& material, physics::SensorKind sensors, const Block& block,
                                          const std::string& where);

}  // namespace cracksim::scene
