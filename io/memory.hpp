#pragma once

#include <cstdint>
#include <optional>

namespace cracksim::io {

/// The most memory that this process has held so far, bytes.
[[nodiscard]] std::int64_t peak_resident_bytes();

/// What the programs on this machine may still take without making it kill one of them, bytes. Empty: not known.
[[nodiscard]] std::optional<std::int64_t> available_bytes();
/// What one of so many processes may hold at most that share this machine's memory evenly, within this process's limit, bytes.
[[nodiscard]] std::int64_t share_of_memory(std::int64_t processes);

}  // namespace cracksim::io
