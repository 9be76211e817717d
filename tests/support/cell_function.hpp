#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "support/interval.hpp"

namespace cracksim::test {

/// A function of (x, y) on a square cell: its value at the centre, its range and the ranges of its two derivatives. The
/// mean value theorem narrows every range, so that the excess of a range shrinks with the square of the cell.
struct CellFunction {
    Interval centre;
    Interval range;
    std::array<Interval, 2> slope{0, 0};
    double half_width = 0;

    CellFunction(double constant) : centre{constant}, range{constant} {}
    CellFunction(Interval at_centre, Interval over_cell, const std::array<Interval, 2>& derivatives, double half)
        : centre{at_centre}, range{over_cell}, slope{derivatives}, half_width{half} {
        const Interval step{-half, half};
        const Interval narrow = centre + slope[0] * step + slope[1] * step;
        range = {std::max(range.low, narrow.low), std::min(range.high, narrow.high)};
    }
};

[[nodiscard]] inline CellFunction operator+(const CellFunction& a, const CellFunction& b) {
    return {a.centre + b.centre,
            a.range + b.range,
            {a.slope[0] + b.slope[0], a.slope[1] + b.slope[1]},
            std::max(a.half_width, b.half_width)};
}
[[nodiscard]] inline CellFunction operator-(const CellFunction& a, const CellFunction& b) {
    return {a.centre - b.centre,
            a.range - b.range,
            {a.slope[0] - b.slope[0], a.slope[1] - b.slope[1]},
            std::max(a.half_width, b.half_width)};
}
[[nodiscard]] inline CellFunction operator*(const CellFunction& a, const CellFunction& b) {
    return {a.centre * b.centre,
            a.range * b.range,
            {a.range * b.slope[0] + a.slope[0] * b.range, a.range * b.slope[1] + a.slope[1] * b.range},
            std::max(a.half_width, b.half_width)};
}
[[nodiscard]] inline CellFunction operator*(double a, const CellFunction& b) {
    return {a * b.centre, a * b.range, {a * b.slope[0], a * b.slope[1]}, b.half_width};
}
/// a must be positive.
[[nodiscard]] inline CellFunction inverse(const CellFunction& a) {
    const Interval range = 1.0 / a.range;
    const Interval by = 0.0 - square(range);
    return {1.0 / a.centre, range, {by * a.slope[0], by * a.slope[1]}, a.half_width};
}
/// a must be positive.
[[nodiscard]] inline CellFunction root(const CellFunction& a) {
    const Interval range = root(a.range);
    const Interval by = 0.5 / range;
    return {root(a.centre), range, {by * a.slope[0], by * a.slope[1]}, a.half_width};
}
[[nodiscard]] inline CellFunction square(const CellFunction& a) {
    const Interval twice = 2.0 * a.range;
    return {square(a.centre), square(a.range), {twice * a.slope[0], twice * a.slope[1]}, a.half_width};
}

[[nodiscard]] inline Answer is_positive(const CellFunction& a) { return is_positive(a.range); }

using CellMatrix = std::array<std::array<CellFunction, 3>, 3>;
[[nodiscard]] inline CellMatrix zero_matrix() { return {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}; }

/// Of a symmetric matrix, by the pivots of elimination: all are positive, or the matrix is not positive definite.
[[nodiscard]] inline Answer is_positive_definite(CellMatrix a) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Answer pivot = is_positive(a[k][k]);
        if (pivot != Answer::yes) {
            return pivot;
        }
        const CellFunction inverse_pivot = inverse(a[k][k]);
        for (std::size_t i = k + 1; i < 3; ++i) {
            for (std::size_t j = i; j < 3; ++j) {
                a[i][j] = a[i][j] - (i == j ? square(a[k][i]) : a[k][i] * a[k][j]) * inverse_pivot;
                a[j][i] = a[i][j];
            }
        }
    }
    return Answer::yes;
}

}  // namespace cracksim::test
