#pragma once

#include <array>
#include <cstdint>

namespace cracksim::test {

/// The geometric meaning of a cube's dart: a flag (corner, edge, face). A cube has 8 corners x 3 edges x 2 faces = 48
/// flags.
struct Flag {
    static constexpr int count = 48;

    int corner;  ///< bit i is set if the corner is on the upper side along axis i
    int edge;    ///< the axis along which the edge runs
    int face;    ///< the axis that is normal to the face; differs from edge

    [[nodiscard]] constexpr bool is_upper_face() const { return (corner >> face & 1) != 0; }
    [[nodiscard]] constexpr int third_axis() const { return 3 - edge - face; }
    [[nodiscard]] constexpr int number() const { return corner * 6 + face * 2 + (edge > third_axis() ? 1 : 0); }

    friend constexpr bool operator==(const Flag&, const Flag&) = default;
};

[[nodiscard]] constexpr Flag flag(int number) {
    const int face = number / 2 % 3;
    const int low = face == 0 ? 1 : 0;
    const int high = 3 - face - low;
    return {number / 6, number % 2 == 0 ? low : high, face};
}

/// The flag that differs in only the corner (i = 0), the edge (1) or the face (2).
[[nodiscard]] constexpr Flag alpha(int i, Flag f) {
    switch (i) {
        case 0: return {f.corner ^ 1 << f.edge, f.edge, f.face};
        case 1: return {f.corner, f.third_axis(), f.face};
        default: return {f.corner, f.edge, f.third_axis()};
    }
}

/// The VTK number of a corner.
[[nodiscard]] constexpr int vtk_corner(int corner) {
    constexpr std::array<int, 8> place{0, 1, 3, 2, 4, 5, 7, 6};
    return place[static_cast<std::size_t>(corner)];
}

/// The name of a dart of a block: 48 * entity + number of its flag.
[[nodiscard]] constexpr std::int64_t dart_name(std::int64_t entity, Flag f) {
    return entity * Flag::count + f.number();
}
[[nodiscard]] constexpr std::int64_t entity_of_dart(std::int64_t name) { return name / Flag::count; }
[[nodiscard]] constexpr Flag flag_of_dart(std::int64_t name) { return flag(static_cast<int>(name % Flag::count)); }

constexpr bool numbers_name_flags() {
    for (int n = 0; n < Flag::count; ++n) {
        if (flag(n).number() != n || flag(n).edge == flag(n).face) {
            return false;
        }
    }
    return true;
}
static_assert(numbers_name_flags());

}  // namespace cracksim::test
