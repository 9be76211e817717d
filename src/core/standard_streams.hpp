#pragma once

namespace cracksim {

/// Ensures that no file that is opened from now on takes the descriptor of a standard stream that was closed when the
/// process started. Writing to such a stream still fails.
void guard_standard_streams();

}  // namespace cracksim
