#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <tuple>

#include "physics/problem/standard_bound.hpp"
#include "physics/standard_law.hpp"

namespace cracksim::test {

[[nodiscard]] inline Vec3 random_vector(std::mt19937_64& random) {
    std::normal_distribution<double> value;
    return {value(random), value(random), value(random)};
}

[[nodiscard]] inline double uniform(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(random);
}

/// The mean edge vectors and the hourglass vectors (standard_law.hpp): v_x, v_y, v_z, q_x, q_y, q_z, q_7.
using Configuration = std::array<Vec3, 7>;

[[nodiscard]] inline physics::CornerVectors displacements(const physics::StandardEntity& entity,
                                                          const Configuration& configuration) {
    physics::CornerVectors u;
    for (std::size_t n = 0; n < u.size(); ++n) {
        std::array<double, 3> s{};
        for (std::size_t i = 0; i < 3; ++i) {
            const int axis = static_cast<int>(i);
            s[i] = 2.0 * Hexahedron::offset[n][i] - 1;
            const double half = s[i] * entity.edge[axis] / 2;
            u[n] += half * configuration[i];
            u[n][axis] -= half;
        }
        for (std::size_t p = 0; p < 3; ++p) {
            u[n] += s[(p + 1) % 3] * s[(p + 2) % 3] * configuration[3 + p];
        }
        u[n] += s[0] * s[1] * s[2] * configuration[6];
    }
    return u;
}

/// Any deformation, folded or not. A third of them have two vectors along one line that are longer than the others:
/// near these lie the largest eigenvalues.
[[nodiscard]] inline Configuration draw(const physics::StandardEntity& entity, std::mt19937_64& random) {
    const double edge = std::cbrt(entity.volume);
    const double on_mean = std::pow(10, uniform(random, -0.5, 0.7));
    const double on_hourglass = edge * std::pow(10, uniform(random, -2, 2));
    Configuration configuration;
    for (Vec3& vector : configuration) {
        vector = random_vector(random);
    }
    const double kind = uniform(random, 0, 3);
    if (kind < 1) {
        for (std::size_t i = 0; i < 3; ++i) {
            configuration[i] = 0.3 * configuration[i];
            configuration[i][static_cast<int>(i)] += 1;
        }
    } else if (kind < 2) {
        const std::size_t axis = random() % 3;
        const Vec3 line = random_vector(random);
        const double others = std::pow(10, uniform(random, -3, 0));
        for (Vec3& vector : configuration) {
            vector = others * vector;
        }
        configuration[axis] += line;
        configuration[3 + random() % 4] += line;
    }
    for (std::size_t i = 0; i < configuration.size(); ++i) {
        configuration[i] = (i < 3 ? on_mean : on_hourglass) * configuration[i];
    }
    return configuration;
}

[[nodiscard]] inline double largest_of_minus(const physics::StandardMatrix& matrix) {
    constexpr auto size = static_cast<Eigen::Index>(std::tuple_size_v<physics::StandardMatrix>);
    using Matrix = Eigen::Matrix<double, size, size, Eigen::RowMajor>;
    const Matrix of = -Eigen::Map<const Matrix>{matrix.front().data()};
    return Eigen::SelfAdjointEigenSolver<Matrix>{(of + of.transpose()) / 2, Eigen::EigenvaluesOnly}
        .eigenvalues()
        .maxCoeff();
}

/// The largest eigenvalues of stiffness and damping, over the bounds.
struct Shares {
    double stiffness;
    double damping;
};

[[nodiscard]] inline Shares shares(const physics::StandardEntity& entity, const physics::StandardBound& bound,
                                   const Configuration& configuration) {
    const physics::StandardTangent tangent =
        physics::standard_tangent(entity, displacements(entity, configuration), {});
    return {largest_of_minus(tangent.by_displacement) / bound.stiffness,
            largest_of_minus(tangent.by_velocity) / bound.damping};
}

/// Half of the times only some of the vectors change.
[[nodiscard]] inline Configuration changed(const Configuration& from, double size, std::mt19937_64& random) {
    Configuration to = from;
    const double on_mean = norm(from[0]) + norm(from[1]) + norm(from[2]);
    const double on_hourglass = norm(from[3]) + norm(from[4]) + norm(from[5]) + norm(from[6]);
    const bool only_some = random() % 2 == 0;
    for (std::size_t i = 0; i < to.size(); ++i) {
        if (!only_some || random() % 3 == 0) {
            to[i] += 0.3 * size * (i < 3 ? on_mean : on_hourglass) * random_vector(random);
        }
    }
    return to;
}

/// Climbs from the best of some random configurations by random changes that become smaller as they fail.
[[nodiscard]] inline double climb(const physics::StandardEntity& entity, double Shares::*share, int starts, int steps,
                                  std::mt19937_64& random) {
    const physics::StandardBound bound = physics::standard_bound(entity);
    Configuration best{};
    double found = 0;
    const auto try_out = [&](const Configuration& configuration) {
        const double here = shares(entity, bound, configuration).*share;
        const bool is_better = here > found;
        if (is_better) {
            best = configuration;
            found = here;
        }
        return is_better;
    };
    for (int n = 0; n < starts; ++n) {
        try_out(draw(entity, random));
    }
    double size = 0.3;
    for (int n = 0; n < steps; ++n) {
        size = try_out(changed(best, size, random)) ? std::min(1.0, 1.5 * size) : 0.97 * size;
    }
    return found;
}

}  // namespace cracksim::test
