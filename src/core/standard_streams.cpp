#include "core/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace cracksim {

void guard_standard_streams() {
    // The lowest free descriptor is taken. To read: writing to it fails, as it did.
    int descriptor = 0;
    while (descriptor >= 0 && descriptor <= STDERR_FILENO) {
        descriptor = open("/dev/null", O_RDONLY);
    }
    if (descriptor > STDERR_FILENO) {
        close(descriptor);
    }
}

}  // namespace cracksim
