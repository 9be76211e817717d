#pragma once

#include <cmath>

namespace cracksim {

struct Vec3 {
    double x{0}, y{0}, z{0};

    [[nodiscard]] constexpr double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
    [[nodiscard]] constexpr double& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }

    friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
    constexpr Vec3& operator+=(Vec3 b) { return *this = *this + b; }
    friend constexpr bool operator==(Vec3, Vec3) = default;
};

[[nodiscard]] constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] constexpr bool has_equal_components(Vec3 a) { return a.x == a.y && a.y == a.z; }
[[nodiscard]] inline double norm(Vec3 a) { return std::sqrt(dot(a, a)); }

}  // namespace cracksim
