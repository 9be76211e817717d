#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "support/oracle_block.hpp"
#include "support/scene_draft.hpp"

namespace cracksim::test {

namespace {

using oracle::Vector;

struct DrawnNotch {
    std::string text;
    std::string option;
    oracle::Notch notch;
};

std::string list(const Vector& v) {
    return "[" + number_text(v[0]) + ", " + number_text(v[1]) + ", " + number_text(v[2]) + "]";
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector rounded(const Vector& v) { return {test::rounded(v[0]), test::rounded(v[1]), test::rounded(v[2])}; }

/// The coordinates of a point in the plane of two sides that start at the origin.
std::array<double, 2> coordinates(const Vector& at, const Vector& first, const Vector& second) {
    const double ff = oracle::dot(first, first);
    const double fs = oracle::dot(first, second);
    const double ss = oracle::dot(second, second);
    const double af = oracle::dot(at, first);
    const double as = oracle::dot(at, second);
    const double determinant = ff * ss - fs * fs;
    return {(af * ss - as * fs) / determinant, (as * ff - af * fs) / determinant};
}

Vector draw_point(SceneDraft& draft) {
    Vector point{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        point[axis] = draft.place(axis, draft.number(0.1, static_cast<double>(draft.scene.cells[axis]) - 0.1));
    }
    return point;
}

/// A vector of about the block's length along an axis, at random oblique.
Vector draw_side(SceneDraft& draft, std::size_t along) {
    Vector side{};
    const bool oblique = draft.chance(0.5);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double share = axis == along ? draft.number(0.5, 1.5) : oblique ? draft.number(-0.4, 0.4) : 0;
        side[axis] = share * draft.length(axis);
    }
    return rounded(side);
}

DrawnNotch draw_rectangle(SceneDraft& draft, const Vector& first, const Vector& second) {
    const Vector diagonal = oracle::plus(first, 1, second);
    const Vector corner = rounded(oracle::plus(draw_point(draft), -0.5, diagonal));
    return {"{rectangle: {corner: " + list(corner) + ", along: " + list(first) + ", and: " + list(second) + "}}",
            "rectangular notch",
            {corner, cross(first, second), [=](const Vector& at) {
                 const auto [a, b] = coordinates(oracle::plus(at, -1, corner), first, second);
                 return 0 <= a && a <= 1 && 0 <= b && b <= 1;
             }}};
}

DrawnNotch draw_triangle(SceneDraft& draft, const Vector& first, const Vector& second) {
    const Vector corner = draw_point(draft);
    const Vector second_corner = rounded(oracle::plus(corner, 1, first));
    const Vector third_corner = rounded(oracle::plus(corner, 1, second));
    const Vector a_side = oracle::plus(second_corner, -1, corner);
    const Vector b_side = oracle::plus(third_corner, -1, corner);
    return {"{polygon: [" + list(corner) + ", " + list(second_corner) + ", " + list(third_corner) + "]}",
            "triangular notch",
            {corner, cross(a_side, b_side), [=](const Vector& at) {
                 const auto [a, b] = coordinates(oracle::plus(at, -1, corner), a_side, b_side);
                 return 0 <= a && 0 <= b && a + b <= 1;
             }}};
}

DrawnNotch draw_disc(SceneDraft& draft, const Vector& normal) {
    const Vector centre = draw_point(draft);
    const double longest = std::max({draft.length(0), draft.length(1), draft.length(2)});
    const double radius = test::rounded(draft.number(0.3, 0.8) * longest);
    return {"{disc: {centre: " + list(centre) + ", normal: " + list(normal) + ", radius: " + number_text(radius) + "}}",
            "disc-shaped notch",
            {centre, normal, [=](const Vector& at) { return oracle::length(oracle::plus(at, -1, centre)) <= radius; }}};
}

DrawnNotch draw_notch(SceneDraft& draft) {
    const std::size_t axis = draft.whole(0, 2);
    const Vector first = draw_side(draft, (axis + 1) % 3);
    const Vector second = draw_side(draft, (axis + 2) % 3);
    switch (draft.whole(0, 2)) {
        case 0: return draw_rectangle(draft, first, second);
        case 1: return draw_triangle(draft, first, second);
        default: return draw_disc(draft, draw_side(draft, axis));
    }
}

/// cracksim refuses a notch that opens nothing.
bool opens_something(const oracle::Scene& scene, const oracle::Notch& notch) {
    oracle::Scene whole = scene;
    whole.notches.clear();
    whole.duplets = oracle::Duplets::corners;
    const std::size_t all = oracle::duplets(whole).size();
    whole.notches = {notch};
    return oracle::duplets(whole).size() < all;
}

}  // namespace

void draw_notches(SceneDraft& draft) {
    std::string text;
    if (draft.chance(0.4)) {
        constexpr int most_tries = 6;
        const std::size_t count = draft.whole(1, 3);
        for (int i = 0; i < most_tries && draft.scene.notches.size() < count; ++i) {
            const DrawnNotch drawn = draw_notch(draft);
            if (opens_something(draft.scene, drawn.notch)) {
                text += "  - where: " + drawn.text + "\n";
                draft.options.insert(drawn.option);
                draft.scene.notches.push_back(drawn.notch);
            }
        }
    }
    draft.options.insert(text.empty() ? "no notches" : "notches");
    draft.text << (text.empty() ? "" : "notches:\n" + text);
}

}  // namespace cracksim::test
