#pragma once

#include <cstdint>

namespace cracksim::io {

/// The most memory that this process has held so far, bytes.
[[nodiscard]] std::int64_t peak_resident_bytes();

/// All the memory that the programs of this machine share, or less if this process is limited to less, bytes.
[[nodiscard]] std::int64_t machine_bytes();

}  // namespace cracksim::io
