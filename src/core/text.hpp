#pragma once

#include <cstdint>
#include <string>

namespace cracksim {

/// The value in 16 hexadecimal digits.
[[nodiscard]] std::string hex(std::uint64_t value);

/// A number as text with at most `digits` significant digits.
[[nodiscard]] std::string rounded(double value, int digits = 4);

/// "950 MB", "1.2 GB", "3.4 TB".
[[nodiscard]] std::string bytes_text(double bytes);
/// "12 s", "3 min 20 s", "2 h 5 min".
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace cracksim
