#pragma once

#include <array>

namespace cracksim {

/// A symmetric tensor: xx, yy, zz, yz, xz, xy.
using SymmetricTensor = std::array<double, 6>;

}  // namespace cracksim
