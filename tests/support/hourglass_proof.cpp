#include "support/hourglass_proof.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "physics/problem/standard_bound.hpp"
#include "support/interval.hpp"

namespace cracksim::test {

namespace {

/// The parameters: the root of w = |V|^2; eta, the weight of Q's direction, from 1/largest_weight_ratio to 1; and y
/// over its largest value, sqrt(w (1 - w) eta).
using Box = std::array<Interval, 3>;

/// Is the form of part 3 below the diagonal form of the corner?
Answer holds(const std::array<double, 2>& corner, const Box& box) {
    const auto& [root_w, weight, share] = box;
    const Interval w = square(root_w);
    const Interval rest = (1.0 - root_w) * (1.0 + root_w);
    const Interval across = root_w * root(rest * weight);
    const Interval y = share * across;
    const Interval excess = (1.0 - weight) * (physics::largest_weight_ratio * weight - 1.0);
    const Interval positive_excess{std::max(0.0, excess.low), std::max(0.0, excess.high)};
    const Interval sigma = rest * root(1.0 + positive_excess) + root(square(w) + square(rest) * positive_excess);
    const Interval on_mean = corner[0] - rest * weight + square(y);
    const Interval on_hourglass = corner[1] - w * square(sigma) + square(y);
    const Interval between = sigma * across + y;
    return both(both(is_positive(on_mean), is_positive(on_hourglass)),
                is_positive(on_mean * on_hourglass - square(between)));
}

double width(const Interval& a) { return a.high - a.low; }

}  // namespace

bool is_hourglass_corner_proved(const std::array<double, 2>& corner) {
    constexpr double narrowest = 1e-6;
    const Interval weight{below(1 / physics::largest_weight_ratio), 1};
    std::vector<Box> open{{Interval{0, 1}, weight, Interval{0, 1}}};
    while (!open.empty()) {
        const Box box = open.back();
        open.pop_back();
        if (holds(corner, box) == Answer::yes) {
            continue;
        }
        const auto middle = [&](std::size_t n) { return (box[n].low + box[n].high) / 2; };
        std::size_t widest = 0;
        for (std::size_t n = 1; n < box.size(); ++n) {
            widest = width(box[n]) > width(box[widest]) ? n : widest;
        }
        const bool is_refuted = holds(corner, {middle(0), middle(1), middle(2)}) == Answer::no;
        if (is_refuted || width(box[widest]) < narrowest) {
            return false;
        }
        open.insert(open.end(), 2, box);
        open.back()[widest].high = middle(widest);
        open[open.size() - 2][widest].low = middle(widest);
    }
    return true;
}

}  // namespace cracksim::test
