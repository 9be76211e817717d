#include "physics/interaction.hpp"

namespace cracksim::physics {

namespace {

constexpr double vanished = 1e-12;

/// The geometry of an interaction. The length is 0 if the direction is not defined.
struct Kinematics {
    Vec3 direction;     ///< n
    double length;      ///< |d|, m
    double elongation;  ///< e, m
};

Kinematics kinematics(Vec3 rest, Vec3 du) {
    const Vec3 d = rest + du;
    const double length = norm(d);
    const double rest_length = norm(rest);
    const double elongation = dot(rest + d, du) / (length + rest_length);
    if (length < vanished * rest_length) {
        return {{}, 0, elongation};
    }
    return {(1 / length) * d, length, elongation};
}

/// The tension s, N.
double tension(const KelvinVoigt& constants, const Kinematics& now, Vec3 dv) {
    return constants.stiffness * now.elongation + constants.viscosity * dot(dv, now.direction);
}

/// The matrix a b^T.
Matrix3 outer(Vec3 a, Vec3 b) { return {a.x * b, a.y * b, a.z * b}; }

}  // namespace

Vec3 interaction_force(const KelvinVoigt& constants, Vec3 rest, Vec3 du, Vec3 dv) {
    const Kinematics now = kinematics(rest, du);
    return tension(constants, now, dv) * now.direction;
}

double interaction_energy(const KelvinVoigt& constants, Vec3 rest, Vec3 du) {
    const double elongation = kinematics(rest, du).elongation;
    return 0.5 * constants.stiffness * elongation * elongation;
}

double interaction_dissipation(const KelvinVoigt& constants, Vec3 rest, Vec3 du, Vec3 dv) {
    const double rate = dot(dv, kinematics(rest, du).direction);
    return constants.viscosity * rate * rate;
}

InteractionTangent interaction_tangent(const KelvinVoigt& constants, Vec3 rest, Vec3 du, Vec3 dv) {
    const Kinematics now = kinematics(rest, du);
    if (now.length == 0) {
        return {};
    }
    const Vec3 n = now.direction;
    const Vec3 dv_across = dv - dot(dv, n) * n;
    const double across = tension(constants, now, dv) / now.length;
    const Matrix3 along = outer(n, constants.stiffness * n + (constants.viscosity / now.length) * dv_across);
    const Matrix3 normal = outer(n, n);
    InteractionTangent tangent{};
    for (int row = 0; row < 3; ++row) {
        const auto r = static_cast<std::size_t>(row);
        tangent.by_displacement[r] = along[r] - across * normal[r];
        tangent.by_displacement[r][row] += across;
        tangent.by_velocity[r] = constants.viscosity * normal[r];
    }
    return tangent;
}

}  // namespace cracksim::physics
