#pragma once

#include <cstddef>

namespace cracksim {

/// Before a list grows by some: where there is no room, room for an eighth more. Takes less memory than doubling.
void make_room(auto& list, std::size_t count) {
    const std::size_t size = list.size() + count;
    if (size > list.capacity()) {
        list.reserve(size + size / 8);
    }
}

}  // namespace cracksim
