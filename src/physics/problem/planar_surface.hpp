#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/vec3.hpp"

namespace cracksim::physics {

/// A bounded part of a plane, a polygon or a disc. Its normal distinguishes its two sides. All lengths are in m.
///
/// A point whose distance from the plane is below the tolerance counts as on the plane, and a point on the plane counts
/// as on the normal's side. A crossing whose distance from the rim is below the tolerance counts as inside. The
/// tolerance is 1e-9 of the scale given at construction (the shortest edge of an entity), so results do not depend on
/// rounding.
class PlanarSurface {
public:
    /// A disc. The normal may have any length. Throws std::invalid_argument with the reason if the disc is degenerate.
    [[nodiscard]] static PlanarSurface disc(Vec3 centre, Vec3 normal, double radius, double scale);
    /// A simple polygon, convex or not. The order of its corners determines the normal by the right-hand rule. Throws
    /// std::invalid_argument with the reason if the polygon is degenerate: fewer than three corners, no area, corners
    /// off the plane, or sides that cross.
    [[nodiscard]] static PlanarSurface polygon(std::span<const Vec3> corners, double scale);
    /// A parallelogram, given by a corner and two sides. Its normal points along the cross product of the sides. Throws
    /// std::invalid_argument with the reason if the sides enclose no area.
    [[nodiscard]] static PlanarSurface rectangle(Vec3 corner, Vec3 along, Vec3 across, double scale);

    /// True if the two points are on different sides of the plane and the line between them crosses the surface.
    [[nodiscard]] bool crosses(Vec3 from, Vec3 to) const;
    /// Lower and upper corner of the surface's bounding box.
    [[nodiscard]] std::array<Vec3, 2> bounds() const;
    [[nodiscard]] Vec3 normal() const { return normal_; }

private:
    /// Coordinates of a point of the plane along its two axes, from origin_.
    using Point2 = std::array<double, 2>;

    PlanarSurface(Vec3 origin, Vec3 normal, double scale);
    [[nodiscard]] double height(Vec3 at) const { return dot(normal_, at - origin_); }
    [[nodiscard]] Point2 in_plane(Vec3 at) const { return {dot(axis_[0], at - origin_), dot(axis_[1], at - origin_)}; }
    [[nodiscard]] bool is_inside(Point2 at) const;
    [[nodiscard]] bool is_inside_outline(Point2 at) const;

    Vec3 origin_;
    Vec3 normal_;               ///< of length 1
    std::array<Vec3, 2> axis_;  ///< of length 1, normal to each other and to normal_
    double tolerance_;          ///< m
    double radius_{0};          ///< of a disc; 0: a polygon
    std::vector<Point2> outline_;
};

}  // namespace cracksim::physics
