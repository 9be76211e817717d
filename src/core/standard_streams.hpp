#pragma once

namespace cracksim {

/// No file that is opened from now on takes the place of a standard stream that was closed from the start; writing to such a
/// stream fails as it did.
void guard_standard_streams();

}  // namespace cracksim
