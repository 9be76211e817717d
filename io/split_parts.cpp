#include "io/split_parts.hpp"

#include <algorithm>
#include <tuple>

#include "core/contracts.hpp"

namespace cracksim::io {

namespace {

struct Part {
    std::int64_t step;
    MassId parent;
    std::span<const MassId> masses;

    [[nodiscard]] auto key() const { return std::tuple{step, parent, masses.front()}; }
};

std::vector<Part> views(const SplitParts& parts) {
    std::vector<Part> list;
    std::size_t first = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const auto count = static_cast<std::size_t>(parts.count[p]);
        list.push_back({parts.step[p], parts.parent[p], std::span{parts.masses}.subspan(first, count)});
        first += count;
    }
    return list;
}

}  // namespace

void SplitParts::add(std::int64_t at_step, MassId of_union, std::span<const MassId> part) {
    CRACKSIM_EXPECT(!part.empty() && std::ranges::is_sorted(part));
    step.push_back(at_step);
    parent.push_back(of_union);
    count.push_back(static_cast<std::int64_t>(part.size()));
    masses.insert(masses.end(), part.begin(), part.end());
}

SplitParts sorted(const SplitParts& parts) {
    std::vector<Part> list = views(parts);
    std::ranges::sort(list, {}, &Part::key);
    const auto same = [](const Part& a, const Part& b) { return a.key() == b.key(); };
    list.erase(std::unique(list.begin(), list.end(), same), list.end());
    SplitParts result;
    for (const Part& part : list) {
        result.add(part.step, part.parent, part.masses);
    }
    return result;
}

}  // namespace cracksim::io
