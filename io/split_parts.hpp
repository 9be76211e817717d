#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/ids.hpp"

namespace cracksim::io {

/// Parts that splits left, in global ids. Part p was split from the union `parent[p]` (its smallest mass id before the
/// split) at step `step[p]`, and holds the next `count[p]` entries of `masses`, in ascending order.
struct SplitParts {
    std::vector<std::int64_t> step;
    std::vector<MassId> parent;
    std::vector<std::int64_t> count;
    std::vector<MassId> masses;

    [[nodiscard]] std::size_t size() const { return step.size(); }
    void add(std::int64_t at_step, MassId of_union, std::span<const MassId> part);
};

/// The parts in order of (step, parent, first mass), each once.
[[nodiscard]] SplitParts sorted(const SplitParts& parts);

}  // namespace cracksim::io
