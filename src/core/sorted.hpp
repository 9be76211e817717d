#pragma once

#include <algorithm>
#include <ranges>

namespace cracksim {

/// Sorts a list and leaves each value once.
void sort_and_make_unique(auto& list) {
    std::ranges::sort(list);
    const auto again = std::ranges::unique(list);
    list.erase(again.begin(), again.end());
}

}  // namespace cracksim
