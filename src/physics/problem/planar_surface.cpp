#include "physics/problem/planar_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/text.hpp"

namespace cracksim::physics {

namespace {

using Point2 = std::array<double, 2>;

constexpr double tolerance_of_scale = 1e-9;
/// The largest distance of a polygon's corner from its plane, relative to the polygon's extent.
constexpr double flatness = 1e-6;

double largest_component(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Twice the area vector of a closed polygon (Newell).
Vec3 doubled_area(std::span<const Vec3> corners) {
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    }
    return sum;
}

double extent(std::span<const Vec3> corners) {
    double largest = 0;
    for (const Vec3& corner : corners) {
        largest = std::max(largest, norm(corner - corners[0]));
    }
    return largest;
}

double cross2(Point2 a, Point2 b) { return a[0] * b[1] - a[1] * b[0]; }
Point2 minus(Point2 a, Point2 b) { return {a[0] - b[0], a[1] - b[1]}; }

/// The distance of a point from the segment a b.
double distance(Point2 at, Point2 a, Point2 b) {
    const Point2 side = minus(b, a);
    const Point2 from = minus(at, a);
    const double squared = side[0] * side[0] + side[1] * side[1];
    const double along = squared > 0 ? std::clamp((from[0] * side[0] + from[1] * side[1]) / squared, 0.0, 1.0) : 0.0;
    return std::hypot(from[0] - along * side[0], from[1] - along * side[1]);
}

/// True if the bounding boxes of two segments, widened by the tolerance, have no point in common.
bool boxes_are_apart(Point2 a, Point2 b, Point2 c, Point2 d, double tolerance) {
    const auto apart = [&](std::size_t axis) {
        return std::max(a[axis], b[axis]) + tolerance < std::min(c[axis], d[axis]) ||
               std::max(c[axis], d[axis]) + tolerance < std::min(a[axis], b[axis]);
    };
    return apart(0) || apart(1);
}

/// True if two segments have a point in common.
bool segments_meet(Point2 a, Point2 b, Point2 c, Point2 d, double tolerance) {
    if (boxes_are_apart(a, b, c, d, tolerance)) {
        return false;
    }
    const double c_side = cross2(minus(b, a), minus(c, a));
    const double d_side = cross2(minus(b, a), minus(d, a));
    const double a_side = cross2(minus(d, c), minus(a, c));
    const double b_side = cross2(minus(d, c), minus(b, c));
    const bool cross_each_other = (c_side > 0) != (d_side > 0) && (a_side > 0) != (b_side > 0);
    return cross_each_other ||
           std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)}) <= tolerance;
}

bool sides_cross(const std::vector<Point2>& outline, double tolerance) {
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 2; j < n; ++j) {
            const bool are_neighbours = i == 0 && j + 1 == n;
            if (!are_neighbours &&
                segments_meet(outline[i], outline[i + 1], outline[j], outline[(j + 1) % n], tolerance)) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace

PlanarSurface::PlanarSurface(Vec3 origin, Vec3 normal, double scale)
    : origin_{origin}, normal_{(1 / norm(normal)) * normal}, axis_{}, tolerance_{tolerance_of_scale * scale} {
    // The coordinate axis that is farthest from the normal determines the first axis of the plane.
    Vec3 far;
    const Vec3 size{std::abs(normal_.x), std::abs(normal_.y), std::abs(normal_.z)};
    far[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
    const Vec3 first = cross(far, normal_);
    axis_[0] = (1 / norm(first)) * first;
    axis_[1] = cross(normal_, axis_[0]);
}

PlanarSurface PlanarSurface::disc(Vec3 centre, Vec3 normal, double radius, double scale) {
    if (!(largest_component(normal) > 0)) {
        throw std::invalid_argument{"has a normal of length 0; give the direction across the disc"};
    }
    PlanarSurface surface{centre, (1 / largest_component(normal)) * normal, scale};
    if (!(radius > surface.tolerance_)) {
        throw std::invalid_argument{"has a radius of " + rounded(radius, 6) +
                                    " m, too small beside an entity; give at least " + rounded(scale, 3) + " m"};
    }
    surface.radius_ = radius;
    return surface;
}

PlanarSurface PlanarSurface::polygon(std::span<const Vec3> corners, double scale) {
    if (corners.size() < 3) {
        throw std::invalid_argument{"has fewer than three corners; give three or more"};
    }
    const Vec3 area = doubled_area(corners);
    const double size = extent(corners);
    if (!(norm(area) > tolerance_of_scale * scale * size)) {
        throw std::invalid_argument{
            "encloses no area: its corners lie on a line, or its sides cross; give each corner once, in order around "
            "it"};
    }
    PlanarSurface surface{corners[0], area, scale};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double off = std::abs(surface.height(corners[i]));
        if (off > flatness * size) {
            throw std::invalid_argument{"is not plane: corner " + std::to_string(i) + " lies " + rounded(off, 3) +
                                        " m off the mean plane through corner 0; move the corners into one plane"};
        }
        surface.outline_.push_back(surface.in_plane(corners[i]));
    }
    if (sides_cross(surface.outline_, surface.tolerance_)) {
        throw std::invalid_argument{
            "has sides that cross or touch each other; give each corner once, in order around it"};
    }
    return surface;
}

PlanarSurface PlanarSurface::rectangle(Vec3 corner, Vec3 along, Vec3 across, double scale) {
    const double longest = std::max(norm(along), norm(across));
    if (!(norm(cross(along, across)) > tolerance_of_scale * scale * longest)) {
        throw std::invalid_argument{"encloses no area: its two sides are parallel, or one of them has length 0"};
    }
    const std::array<Vec3, 4> corners{corner, corner + along, corner + along + across, corner + across};
    return polygon(corners, scale);
}

bool PlanarSurface::crosses(Vec3 from, Vec3 to) const {
    const double start = height(from);
    const double end = height(to);
    const bool start_is_on_normals_side = start >= -tolerance_;
    const bool end_is_on_normals_side = end >= -tolerance_;
    if (start_is_on_normals_side == end_is_on_normals_side) {
        return false;
    }
    // A point that counts as on the plane may lie beyond it by up to the tolerance.
    const double share = std::clamp(start / (start - end), 0.0, 1.0);
    return is_inside(in_plane(from + share * (to - from)));
}

bool PlanarSurface::is_inside(Point2 at) const {
    return outline_.empty() ? std::hypot(at[0], at[1]) <= radius_ + tolerance_ : is_inside_outline(at);
}

bool PlanarSurface::is_inside_outline(Point2 at) const {
    bool inside = false;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
        const Point2 a = outline_[i];
        const Point2 b = outline_[(i + 1) % outline_.size()];
        if (distance(at, a, b) <= tolerance_) {
            return true;
        }
        // The ray from the point along the first axis crosses the side.
        const bool spans = (a[1] > at[1]) != (b[1] > at[1]);
        if (spans && at[0] < a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) {
            inside = !inside;
        }
    }
    return inside;
}

std::array<Vec3, 2> PlanarSurface::bounds() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<Vec3, 2> box{Vec3{infinity, infinity, infinity}, Vec3{-infinity, -infinity, -infinity}};
    for (int axis = 0; axis < 3; ++axis) {
        if (outline_.empty()) {
            const double reach = radius_ * std::sqrt(std::max(0.0, 1 - normal_[axis] * normal_[axis]));
            box[0][axis] = origin_[axis] - reach;
            box[1][axis] = origin_[axis] + reach;
        }
        for (const Point2& corner : outline_) {
            const double at = origin_[axis] + corner[0] * axis_[0][axis] + corner[1] * axis_[1][axis];
            box[0][axis] = std::min(box[0][axis], at);
            box[1][axis] = std::max(box[1][axis], at);
        }
    }
    return box;
}

}  // namespace cracksim::physics
