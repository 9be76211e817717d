#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace cracksim::topology {

/// Disjoint sets (union-find) of 0..size-1 (Galler and Fischer 1964). The smallest member represents its set, so the
/// result does not depend on the order of the joins.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    [[nodiscard]] std::size_t size() const { return parent_.size(); }

    /// The smallest member of i's set.
    [[nodiscard]] std::size_t find(std::size_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void join(std::size_t i, std::size_t j) {
        const auto [low, high] = std::minmax({find(i), find(j)});
        parent_[high] = low;
    }

private:
    std::vector<std::size_t> parent_;
};

}  // namespace cracksim::topology
