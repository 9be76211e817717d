#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace cracksim::test {

/// A number below a, and below every real number that rounds to a. Holds with and without subnormal numbers.
[[nodiscard]] inline double below(double a) {
    return a - (std::abs(a) * std::numeric_limits<double>::epsilon() + std::numeric_limits<double>::min());
}
[[nodiscard]] inline double above(double a) { return -below(-a); }

/// A closed interval of real numbers. An operation's result contains all of its values on the operands.
struct Interval {
    double low;
    double high;

    Interval(double value) : low{value}, high{value} {}
    Interval(double least, double largest) : low{least}, high{largest} {}
};

[[nodiscard]] inline Interval operator+(Interval a, Interval b) {
    return {below(a.low + b.low), above(a.high + b.high)};
}
[[nodiscard]] inline Interval operator-(Interval a, Interval b) {
    return {below(a.low - b.high), above(a.high - b.low)};
}
[[nodiscard]] inline Interval operator*(Interval a, Interval b) {
    const double ends[]{a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    return {below(std::min(std::min(ends[0], ends[1]), std::min(ends[2], ends[3]))),
            above(std::max(std::max(ends[0], ends[1]), std::max(ends[2], ends[3])))};
}
/// Throws std::domain_error if b is not positive.
[[nodiscard]] inline Interval operator/(Interval a, Interval b) {
    if (!(b.low > 0)) {
        throw std::domain_error{"division by an interval that is not positive"};
    }
    return a * Interval{below(1 / b.high), above(1 / b.low)};
}
[[nodiscard]] inline Interval square(Interval a) {
    const double least = std::max({0.0, a.low, -a.high});
    const double largest = std::max(-a.low, a.high);
    return {std::max(0.0, below(least * least)), above(largest * largest)};
}
/// Of the part of a that is not negative.
[[nodiscard]] inline Interval root(Interval a) {
    return {std::max(0.0, below(std::sqrt(std::max(0.0, a.low)))), above(std::sqrt(std::max(0.0, a.high)))};
}

/// What intervals say of a statement. unknown: they are too wide.
enum class Answer { yes, no, unknown };

[[nodiscard]] inline Answer is_positive(Interval a) {
    if (a.low > 0) {
        return Answer::yes;
    }
    return a.high < 0 ? Answer::no : Answer::unknown;
}

[[nodiscard]] inline Answer both(Answer a, Answer b) {
    if (a == Answer::no || b == Answer::no) {
        return Answer::no;
    }
    return a == Answer::yes && b == Answer::yes ? Answer::yes : Answer::unknown;
}

}  // namespace cracksim::test
