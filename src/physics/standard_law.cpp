#include "physics/standard_law.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <unsupported/Eigen/AutoDiff>

namespace cracksim::physics {

namespace {

constexpr double vanished = 1e-200;
constexpr std::size_t components = 3 * Hexahedron::corners;
constexpr std::size_t hourglasses = 4;

template <class T>
using Vector = std::array<T, 3>;
template <class T>
using Corners = std::array<Vector<T>, Hexahedron::corners>;

template <class T>
T dot_of(const Vector<T>& a, const Vector<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
void add(Vector<T>& to, const T& factor, const Vector<T>& a) {
    for (std::size_t c = 0; c < 3; ++c) {
        to[c] = to[c] + factor * a[c];
    }
}

/// The signs of a corner: s_x, s_y, s_z, and those of the hourglass vectors.
constexpr double sign(std::size_t corner, std::size_t axis) { return 2.0 * Hexahedron::offset[corner][axis] - 1; }
constexpr double hourglass_sign(std::size_t corner, std::size_t p) {
    const double all = sign(corner, 0) * sign(corner, 1) * sign(corner, 2);
    return p < 3 ? all * sign(corner, p) : all;
}

/// The mean edge vectors and the hourglass vectors of some vectors at the corners: displacements or velocities.
template <class T>
struct Modes {
    std::array<Vector<T>, 3> mean;
    std::array<Vector<T>, hourglasses> hourglass;
};

template <class T>
Modes<T> modes(const StandardEntity& entity, const Corners<T>& at) {
    // The signs of every mode sum to zero. Differences from corner 0 make a translation vanish exactly.
    Corners<T> corner = at;
    for (Vector<T>& one : corner) {
        for (std::size_t c = 0; c < 3; ++c) {
            one[c] = one[c] - at[0][c];
        }
    }
    Modes<T> found;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < 3; ++i) {
            T sum = T(0);
            for (std::size_t n = 0; n < corner.size(); ++n) {
                sum = sum + sign(n, i) * corner[n][c];
            }
            found.mean[i][c] = sum / (4 * entity.edge[static_cast<int>(i)]);
        }
        for (std::size_t p = 0; p < hourglasses; ++p) {
            T sum = T(0);
            for (std::size_t n = 0; n < corner.size(); ++n) {
                sum = sum + hourglass_sign(n, p) * corner[n][c];
            }
            found.hourglass[p][c] = sum / 8.0;
        }
    }
    return found;
}

template <class T>
using Square = std::array<std::array<T, 3>, 3>;

/// The deformation of an entity and its rates.
template <class T>
struct Deformation {
    std::array<Vector<T>, 3> v;            ///< v_i
    std::array<Vector<T>, 3> v_rate;       ///< 1/s
    std::array<Vector<T>, hourglasses> q;  ///< q_P, m
    std::array<Vector<T>, hourglasses> q_rate;
    T dilation;  ///< s - 1, without cancellation at small strain
    T s;
    Square<T> d;
    T n2;
    T norm2;                               ///< N2
    T weight;                              ///< D
    std::array<Vector<T>, hourglasses> m;  ///< M_Pi
    std::array<Vector<T>, hourglasses> r;  ///< r_Pi
};

template <class T>
void find_strain(const std::array<Vector<T>, 3>& h, Deformation<T>& now) {
    Square<T> strain;  // C - I
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            strain[i][j] = h[i][j] + h[j][i] + dot_of(h[i], h[j]);
        }
    }
    now.dilation = (strain[0][0] + strain[1][1] + strain[2][2]) / 3.0;
    now.s = 1.0 + now.dilation;
    now.n2 = T(0);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            now.d[i][j] = i == j ? T(strain[i][j] - now.dilation) : strain[i][j];
            now.n2 = now.n2 + now.d[i][j] * now.d[i][j];
        }
    }
    now.norm2 = now.n2 + 3.0 * now.s * now.s;
}

template <class T>
Deformation<T> deformation(const StandardEntity& entity, const Corners<T>& u, const Corners<T>& velocity) {
    const Modes<T> moved = modes(entity, u);
    const Modes<T> rate = modes(entity, velocity);
    Deformation<T> now;
    now.v = moved.mean;
    for (std::size_t i = 0; i < 3; ++i) {
        now.v[i][i] = now.v[i][i] + 1.0;
    }
    now.v_rate = rate.mean;
    now.q = moved.hourglass;
    now.q_rate = rate.hourglass;
    find_strain(moved.mean, now);
    now.weight = now.s;
    for (std::size_t p = 0; p < hourglasses; ++p) {
        now.weight = now.weight + entity.bound_weight[p] * dot_of(now.q[p], now.q[p]);
        for (std::size_t i = 0; i < 3; ++i) {
            now.m[p][i] = dot_of(now.q[p], now.v[i]);
            now.r[p][i] = dot_of(now.q_rate[p], now.v[i]) + dot_of(now.q[p], now.v_rate[i]);
        }
    }
    return now;
}

/// W_PQ.
double warping(const StandardEntity& entity, std::size_t p, std::size_t q) {
    return entity.warping ? (*entity.warping)[p][q] : p == q ? entity.isotropic[p] : 0.0;
}

/// The sum over the coefficients of the form of damping, 2 sum_(Qj) (...)_(Pi)(Qj) of amplitudes; without the part of
/// p_P it is the form of N, halved derivative.
template <class T>
T form(const StandardEntity& entity, const std::array<Vector<T>, hourglasses>& of, std::size_t p, std::size_t i,
       double isotropic_share) {
    const double taken = isotropic_share * entity.isotropic[p];
    if (p == 3) {
        return (entity.isotropic[3] - taken) * of[3][i];
    }
    if (p != i) {
        return (entity.bending[i] - taken) * of[p][i] + entity.coupling[3 - p - i] * of[i][p];
    }
    T sum = -taken * of[p][p];
    for (std::size_t other = 0; other < 3; ++other) {
        sum = sum + warping(entity, p, other) * of[other][other];
    }
    return sum;
}

/// N.
template <class T>
T numerator(const StandardEntity& entity, const Deformation<T>& now) {
    T sum = T(0);
    for (std::size_t p = 0; p < hourglasses; ++p) {
        for (std::size_t i = 0; i < 3; ++i) {
            sum = sum + now.m[p][i] * form(entity, now.m, p, i, 1.0);
        }
    }
    return sum;
}

/// What acts on the modes: the forces on v_i (N m) and on q_P (N), negative.
template <class T>
struct ModeForces {
    std::array<Vector<T>, 3> on_mean;
    std::array<Vector<T>, hourglasses> on_hourglass;
};

/// The coefficients of the stress: S = iso I + a4 d, with damping.
template <class T>
struct Stress {
    T iso;
    T a4;
    Square<T> d;
};

template <class T>
Stress<T> elastic_stress(const StandardEntity& entity, const Deformation<T>& now) {
    const T sum = now.s + 1.0;
    Stress<T> stress{1.5 * entity.bulk * now.dilation * (now.s + 3.0) / (sum * sum), T(0), now.d};
    if (now.norm2 >= vanished) {
        const T squared = now.norm2 * now.norm2;
        stress.iso = stress.iso + 0.5 * entity.shear * now.n2 * (now.n2 - 3.0 * now.s * now.s) / squared;
        stress.a4 = 9.0 * entity.shear * now.s * now.s * now.s / squared;
    }
    return stress;
}

template <class T>
void add_viscous(const StandardEntity& entity, const Deformation<T>& now, Stress<T>& stress) {
    const double beta = entity.solid.damping_time;
    const T sum = now.s + 1.0;
    Square<T> rate;  // C'
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            rate[i][j] = dot_of(now.v[i], now.v_rate[j]) + dot_of(now.v[j], now.v_rate[i]);
        }
    }
    const T trace = rate[0][0] + rate[1][1] + rate[2][2];
    stress.iso = stress.iso + 2.0 * entity.bulk * beta * trace / (sum * sum);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            stress.d[i][j] = stress.d[i][j] + beta * (i == j ? T(rate[i][j] - trace / 3.0) : rate[i][j]);
        }
    }
}

/// elastic, viscous: 1 or 0, the parts of the force that count.
template <class T>
ModeForces<T> mode_forces(const StandardEntity& entity, const Deformation<T>& now, double elastic, double viscous) {
    Stress<T> stress = elastic_stress(entity, now);
    if (elastic == 0) {
        stress.iso = T(0);
        stress.d = {{{T(0), T(0), T(0)}, {T(0), T(0), T(0)}, {T(0), T(0), T(0)}}};
    }
    if (viscous != 0) {
        add_viscous(entity, now, stress);
    }
    ModeForces<T> found;
    for (std::size_t i = 0; i < 3; ++i) {
        found.on_mean[i] = {T(0), T(0), T(0)};
        add<T>(found.on_mean[i], entity.volume * stress.iso, now.v[i]);
        for (std::size_t j = 0; j < 3; ++j) {
            add<T>(found.on_mean[i], entity.volume * stress.a4 * stress.d[i][j], now.v[j]);
        }
    }
    const bool has_weight = now.weight >= vanished;
    const T bound = has_weight ? T(elastic * numerator(entity, now) / (now.weight * now.weight)) : T(0);
    for (std::size_t p = 0; p < hourglasses; ++p) {
        found.on_hourglass[p] = {T(0), T(0), T(0)};
        add<T>(found.on_hourglass[p], elastic * 2.0 * entity.isotropic[p] - 2.0 * entity.bound_weight[p] * bound,
               now.q[p]);
        for (std::size_t i = 0; has_weight && i < 3; ++i) {
            const T t = 2.0 / now.weight *
                        (elastic * form(entity, now.m, p, i, 1.0) +
                         viscous * entity.solid.damping_time * form(entity, now.r, p, i, 0.0));
            add<T>(found.on_hourglass[p], t, now.v[i]);
            add<T>(found.on_mean[i], t, now.q[p]);
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        add<T>(found.on_mean[i], -2.0 / 3.0 * bound, now.v[i]);
    }
    return found;
}

template <class T>
Corners<T> corner_forces(const StandardEntity& entity, const ModeForces<T>& modes) {
    Corners<T> found;
    for (std::size_t n = 0; n < found.size(); ++n) {
        found[n] = {T(0), T(0), T(0)};
        for (std::size_t i = 0; i < 3; ++i) {
            add<T>(found[n], T(-sign(n, i) / (4 * entity.edge[static_cast<int>(i)])), modes.on_mean[i]);
        }
        for (std::size_t p = 0; p < hourglasses; ++p) {
            add<T>(found[n], T(-hourglass_sign(n, p) / 8), modes.on_hourglass[p]);
        }
    }
    return found;
}

template <class T>
Corners<T> numbers(const CornerVectors& of) {
    Corners<T> found;
    for (std::size_t n = 0; n < of.size(); ++n) {
        found[n] = {T(of[n].x), T(of[n].y), T(of[n].z)};
    }
    return found;
}

using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, components, 1>>;

Corners<Dual> variables(const CornerVectors& at) {
    Corners<Dual> found = numbers<Dual>(at);
    for (std::size_t i = 0; i < components; ++i) {
        Dual& component = found[i / 3][i % 3];
        component = Dual{component.value(), static_cast<int>(components), static_cast<int>(i)};
    }
    return found;
}

Corners<Dual> fixed(const CornerVectors& at) {
    Corners<Dual> found;
    for (std::size_t i = 0; i < components; ++i) {
        Dual& component = found[i / 3][i % 3];
        component = Dual{at[i / 3][static_cast<int>(i % 3)], Dual::DerType::Zero()};
    }
    return found;
}

StandardMatrix derivatives(const StandardEntity& entity, const Corners<Dual>& u, const Corners<Dual>& velocity) {
    const Corners<Dual> force = corner_forces(entity, mode_forces(entity, deformation(entity, u, velocity), 1, 1));
    StandardMatrix found{};
    for (std::size_t row = 0; row < components; ++row) {
        for (std::size_t column = 0; column < components; ++column) {
            found[row][column] = force[row / 3][row % 3].derivatives()[static_cast<Eigen::Index>(column)];
        }
    }
    return found;
}

Deformation<double> deformation_of(const StandardEntity& entity, const CornerVectors& u,
                                   const CornerVectors& velocity) {
    return deformation(entity, numbers<double>(u), numbers<double>(velocity));
}

}  // namespace

double standard_energy(const StandardEntity& entity, const CornerVectors& u) {
    const Deformation<double> now = deformation_of(entity, u, {});
    double energy = 2.25 * entity.bulk * now.dilation * now.dilation / (1 + now.s);
    if (now.norm2 >= vanished) {
        energy += 0.75 * entity.shear * now.s * now.n2 / now.norm2;
    }
    energy *= entity.volume;
    for (std::size_t p = 0; p < hourglasses; ++p) {
        energy += entity.isotropic[p] * dot_of(now.q[p], now.q[p]);
    }
    return now.weight >= vanished ? energy + numerator(entity, now) / now.weight : energy;
}

CornerVectors standard_forces(const StandardEntity& entity, const CornerVectors& u, const CornerVectors& velocity) {
    const auto force = corner_forces(entity, mode_forces(entity, deformation_of(entity, u, velocity), 1, 1));
    CornerVectors found;
    for (std::size_t n = 0; n < found.size(); ++n) {
        found[n] = {force[n][0], force[n][1], force[n][2]};
    }
    return found;
}

double standard_dissipation(const StandardEntity& entity, const CornerVectors& u, const CornerVectors& velocity) {
    const Deformation<double> now = deformation_of(entity, u, velocity);
    const ModeForces<double> damping = mode_forces(entity, now, 0, 1);
    double power = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        power += dot_of(damping.on_mean[i], now.v_rate[i]);
    }
    for (std::size_t p = 0; p < hourglasses; ++p) {
        power += dot_of(damping.on_hourglass[p], now.q_rate[p]);
    }
    return power;
}

SymmetricTensor standard_stress(const StandardEntity& entity, const CornerVectors& u) {
    const Stress<double> stress = elastic_stress(entity, deformation_of(entity, u, {}));
    const auto& d = stress.d;
    return {stress.iso + stress.a4 * d[0][0],
            stress.iso + stress.a4 * d[1][1],
            stress.iso + stress.a4 * d[2][2],
            stress.a4 * d[1][2],
            stress.a4 * d[0][2],
            stress.a4 * d[0][1]};
}

StandardTangent standard_tangent(const StandardEntity& entity, const CornerVectors& u, const CornerVectors& velocity) {
    return {derivatives(entity, variables(u), fixed(velocity)), derivatives(entity, fixed(u), variables(velocity))};
}

}  // namespace cracksim::physics
