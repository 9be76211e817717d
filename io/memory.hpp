#pragma once

#include <cstdint>
#include <optional>

namespace cracksim::io {

/// The most memory that this process has held so far, bytes.
[[nodiscard]] std::int64_t peak_resident_bytes();

/// What the programs on this machine may still take without making it kill one of them, bytes. Empty: not known.
[[nodiscard]] std::optional<std::int64_t> available_bytes();

}  // namespace cracksim::io
