#pragma once

namespace cracksim {

/// Makes this thread treat subnormal numbers as zero from now on. Every rank must call it.
void flush_subnormals_to_zero();

}  // namespace cracksim
