#include "core/contracts.hpp"

#include <cstdio>
#include <cstdlib>

namespace cracksim {

void contract_violated(const char* role, const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: %s does not hold: %s\n", file, line, role, condition);
    std::abort();
}

}  // namespace cracksim
