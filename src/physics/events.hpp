#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/ids.hpp"

namespace cracksim::physics {

/// A duplet that its sensor inactivated at a step. The smaller mass id comes first.
struct DupletEvent {
    std::int64_t step;
    MassId mass_a;
    MassId mass_b;

    friend auto operator<=>(const DupletEvent&, const DupletEvent&) = default;
};

/// The state stream of the Mass-unions (Riffet et al. 2.2): the parts of each union that split, as lists of this rank's
/// masses. Split s happened at step(s), time(s) and left parts(s) parts. The masses of a part ascend, and parts ascend
/// by their first masses.
class SplitStream {
public:
    [[nodiscard]] std::size_t size() const { return step_.size(); }
    [[nodiscard]] bool empty() const { return step_.empty(); }
    [[nodiscard]] std::int64_t step(std::size_t split) const { return step_[split]; }
    /// Time of the split, s.
    [[nodiscard]] double time(std::size_t split) const { return time_[split]; }
    [[nodiscard]] std::size_t parts(std::size_t split) const { return first_part(split + 1) - first_part(split); }
    [[nodiscard]] std::span<const LocalMass> part(std::size_t split, std::size_t k) const {
        const std::size_t p = first_part(split) + k;
        const std::size_t begin = p == 0 ? 0 : part_end_[p - 1];
        return std::span{masses_}.subspan(begin, part_end_[p] - begin);
    }

    void begin_split(std::int64_t step, double time) {
        step_.push_back(step);
        time_.push_back(time);
        split_end_.push_back(part_end_.size());
    }
    /// Adds a part to the split that was begun last.
    void add_part(std::span<const LocalMass> masses) {
        masses_.insert(masses_.end(), masses.begin(), masses.end());
        part_end_.push_back(masses_.size());
        split_end_.back() = part_end_.size();
    }
    void clear() { *this = {}; }

private:
    [[nodiscard]] std::size_t first_part(std::size_t split) const { return split == 0 ? 0 : split_end_[split - 1]; }

    std::vector<std::int64_t> step_;
    std::vector<double> time_;
    std::vector<std::size_t> split_end_;
    std::vector<std::size_t> part_end_;
    std::vector<LocalMass> masses_;
};

}  // namespace cracksim::physics
