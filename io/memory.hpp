#pragma once

#include <cstdint>

namespace cracksim::io {

/// The most memory that this process has held so far, bytes.
[[nodiscard]] std::int64_t peak_resident_bytes();

}  // namespace cracksim::io
