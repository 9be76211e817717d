#include "core/float_environment.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace cracksim {

void flush_subnormals_to_zero() {
#if defined(__SSE2__)
    constexpr unsigned flush_results = 0x8000;
    constexpr unsigned flush_operands = 0x0040;
    _mm_setcsr(_mm_getcsr() | flush_results | flush_operands);
#endif
}

}  // namespace cracksim
