#pragma once

#include <algorithm>

namespace cracksim {

/// Sorts a list and leaves each value once.
void sort_and_make_unique(auto& list) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace cracksim
