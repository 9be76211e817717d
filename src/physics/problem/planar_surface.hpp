#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/vec3.hpp"

namespace cracksim::physics {

/// A bounded part of a plane: a polygon or a disc, with a normal that tells its two sides apart. All lengths in m.
///
/// A point closer to the plane than the tolerance counts as on it, and a point on the plane counts on the normal's side.
/// A crossing closer to the rim than the tolerance counts as inside. The tolerance is 1e-9 of the scale given at
/// construction (the shortest edge of an entity), so rounding decides nothing.
class PlanarSurface {
public:
    /// The disc of a centre, a normal of any length and a radius. Throws std::invalid_argument that says why the disc is
    /// degenerate.
    [[nodiscard]] static PlanarSurface disc(Vec3 centre, Vec3 normal, double radius, double scale);
    /// The simple polygon of its corners in order, convex or not; the normal follows from the order by the right-hand rule.
    /// Throws std::invalid_argument that says why the polygon is degenerate: fewer than three corners, no area, corners off
    /// the plane, or sides that cross.
    [[nodiscard]] static PlanarSurface polygon(std::span<const Vec3> corners, double scale);
    /// The parallelogram of a corner and two sides; its normal points along the cross product of the sides.
    [[nodiscard]] static PlanarSurface rectangle(Vec3 corner, Vec3 along, Vec3 across, double scale);

    /// The two points are on different sides of the plane, and the line between them crosses it inside the surface.
    [[nodiscard]] bool crosses(Vec3 from, Vec3 to) const;
    /// Lower and upper corner of the box around the surface.
    [[nodiscard]] std::array<Vec3, 2> bounds() const;
    [[nodiscard]] Vec3 normal() const { return normal_; }

private:
    /// A point of the plane along its two axes, from origin_.
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
