#include "core/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace cracksim {

void guard_standard_streams() {
    // open() takes the lowest free descriptor. O_RDONLY, so that writing to it still fails.
    int descriptor = 0;
    while (descriptor >= 0 && descriptor <= STDERR_FILENO) {
        descriptor = open("/dev/null", O_RDONLY);
    }
    if (descriptor > STDERR_FILENO) {
        close(descriptor);
    }
}

}  // namespace cracksim
