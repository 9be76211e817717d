#pragma once

#include <cstdint>
#include <optional>

namespace cracksim::io {

/// Peak resident memory of this process, bytes.
[[nodiscard]] std::int64_t peak_resident_bytes();

/// Memory that programs on this machine can still take before the system kills one of them, bytes; empty if unknown.
[[nodiscard]] std::optional<std::int64_t> available_bytes();
/// Largest memory of one process, bytes, if `processes` processes share this machine's memory evenly and keep within
/// this process's limit.
[[nodiscard]] std::int64_t share_of_memory(std::int64_t processes);

}  // namespace cracksim::io
