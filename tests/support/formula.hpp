#pragma once

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "support/oracle.hpp"

namespace cracksim::test {

/// A number or expression of a scene: the text that a user would write, and its meaning.
struct Formula {
    std::string text;
    oracle::Field value;
};

/// The shortest text of a number that has at most four digits.
inline std::string number_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

/// The value of number_text(value).
inline double rounded(double value) { return std::strtod(number_text(value).c_str(), nullptr); }

inline Formula constant(double value) {
    return {number_text(value), [value = rounded(value)](const oracle::Vector&, double) { return value; }};
}

inline Formula coordinate(std::size_t axis) {
    return {std::string{"xyz"[axis]}, [axis](const oracle::Vector& at, double) { return at[axis]; }};
}

inline Formula time() {
    return {"t", [](const oracle::Vector&, double t) { return t; }};
}

inline Formula operator+(const Formula& a, const Formula& b) {
    return {a.text + " + " + b.text,
            [a = a.value, b = b.value](const oracle::Vector& at, double t) { return a(at, t) + b(at, t); }};
}

inline Formula operator*(const Formula& a, const Formula& b) {
    return {"(" + a.text + ")*(" + b.text + ")",
            [a = a.value, b = b.value](const oracle::Vector& at, double t) { return a(at, t) * b(at, t); }};
}

inline Formula sin(const Formula& a) {
    return {"sin(" + a.text + ")", [a = a.value](const oracle::Vector& at, double t) { return std::sin(a(at, t)); }};
}

inline Formula exp(const Formula& a) {
    return {"exp(" + a.text + ")", [a = a.value](const oracle::Vector& at, double t) { return std::exp(a(at, t)); }};
}

/// The formula `a < b ? yes : no`.
inline Formula below(const Formula& a, const Formula& b, const Formula& yes, const Formula& no) {
    return {a.text + " < " + b.text + " ? " + yes.text + " : " + no.text,
            [a = a.value, b = b.value, yes = yes.value, no = no.value](const oracle::Vector& at, double t) {
                return a(at, t) < b(at, t) ? yes(at, t) : no(at, t);
            }};
}

}  // namespace cracksim::test
