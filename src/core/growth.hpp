#pragma once

#include <cstddef>

namespace cracksim {

/// Makes room for `count` more elements. If the capacity is too small, reserves an eighth more than the new size, which
/// takes less memory than doubling.
void make_room(auto& list, std::size_t count) {
    const std::size_t size = list.size() + count;
    if (size > list.capacity()) {
        list.reserve(size + size / 8);
    }
}

}  // namespace cracksim
