#pragma once

namespace cracksim {

/// Numbers too small for full precision become zero from now on in this thread, as they must on every rank alike.
void flush_subnormals_to_zero();

}  // namespace cracksim
