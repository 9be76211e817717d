#pragma once

#include <algorithm>

namespace cracksim {

/// Sorts a list and removes repeated values.
void sort_and_make_unique(auto& list) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace cracksim
