#pragma once

#include <cstdint>
#include <string>

namespace cracksim {

/// 16 hexadecimal digits, as hashes are shown.
[[nodiscard]] std::string hex(std::uint64_t value);

/// A number for people, with at most so many significant digits.
[[nodiscard]] std::string rounded(double value, int digits = 4);

}  // namespace cracksim
