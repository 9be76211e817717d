#include "support/mean_energy_proof.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "support/cell_function.hpp"

namespace cracksim::test {

namespace {

using physics::BoundRay;

/// Principal stretches in the ratio 1 : x : y, scaled to sum u_i^2 = 3.
struct Direction {
    std::array<CellFunction, 3> u;
    std::array<CellFunction, 3> squared;  ///< u_i^2
    CellFunction t;                       ///< 1 / sum u_i^4
    CellFunction tt;                      ///< t^2

    [[nodiscard]] CellFunction product(std::size_t i, std::size_t j) const { return i == j ? squared[i] : u[i] * u[j]; }
};

Direction direction(const CellFunction& x, const CellFunction& y) {
    const CellFunction xx = square(x);
    const CellFunction yy = square(y);
    const CellFunction sum = 1.0 + xx + yy;
    const CellFunction scale = 3.0 * inverse(sum);
    const CellFunction length = root(scale);
    const CellFunction t = square(sum) * inverse(9.0 * (1.0 + square(xx) + square(yy)));
    return {{length, x * length, y * length}, {scale, xx * scale, yy * scale}, t, square(t)};
}

/// The second derivatives of the shape energy, mu = 1, by the diagonal of F, in the frame of the singular vectors.
CellMatrix shape_block(const Direction& d) {
    const CellFunction ttt = d.tt * d.t;
    const CellFunction same = 0.5 - 4.5 * d.t;
    CellMatrix block = zero_matrix();
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
            const CellFunction inner = 18.0 * (d.tt * (d.squared[i] + d.squared[j])) - 6.0 * d.t -
                                       72.0 * (ttt * (d.squared[i] * d.squared[j]));
            block[i][j] = d.product(i, j) * inner;
            if (i == j) {
                block[i][i] = block[i][i] + same + 27.0 * (d.tt * d.squared[i]);
            }
            block[j][i] = block[i][j];
        }
    }
    return block;
}

/// The same by the elements ij and ji of F, j the axis after i: [[own, coupling], [coupling, own]].
struct PairBlock {
    CellFunction own;
    CellFunction coupling;
};
CellFunction pair_of_damping(const Direction& d, std::size_t i) {
    return 9.0 * (d.tt * (d.squared[i] + d.squared[(i + 1) % 3]));
}
PairBlock shape_pair(const Direction& d, std::size_t i) {
    return {0.5 - 4.5 * d.t + pair_of_damping(d, i), 9.0 * (d.tt * d.product(i, (i + 1) % 3))};
}

CellMatrix operator*(double factor, CellMatrix a) {
    for (auto& row : a) {
        for (CellFunction& element : row) {
            element = factor * element;
        }
    }
    return a;
}

/// Is bound I - block - radial u u^T positive definite?
Answer is_above(const CellFunction& bound, const CellMatrix& block, const Direction& d, const CellFunction& radial) {
    CellMatrix rest = zero_matrix();
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
            rest[i][j] = CellFunction{0} - block[i][j] - radial * d.product(i, j);
            rest[j][i] = rest[i][j];
        }
        rest[i][i] = rest[i][i] + bound;
    }
    return is_positive_definite(rest);
}

// The part of the Hessian with kappa is kappa (even(z) I + radial(z) u u^T), z = 1/(1 + s), with even(z) for pairs too.
// It is computed at the ends of slabs of z. Inside a slab it is below the chord plus an eighth of the squared width
// times the largest -d2/dz2, which is kappa max(12, 144 z - 36). At multiples of 1/64, none of these numbers is
// rounded.
constexpr int slabs = 64;
double even(double z) { return 1.5 - 6 * z * z; }
double radial(double z) { return 8 * z * z * (1 - z); }

/// What ray.value leaves for the other parts at z, in slabs of a width that end at last.
CellFunction room(const BoundRay& ray, double z, double width, double last) {
    const double curvature = std::max(12.0, 144 * last - 36);
    return CellFunction{ray.value} - ray.bulk * CellFunction{even(z) + curvature * width * width / 8};
}

/// Is bound I - radial u u^T positive definite? |u|^2 = 3.
Answer is_above(const CellFunction& bound, const CellFunction& radial) {
    return both(is_positive(bound), is_positive(bound - 3.0 * radial));
}

Answer is_stiffness(const BoundRay& ray, const Direction& d) {
    const CellMatrix block = ray.shear * shape_block(d);
    Answer answer = Answer::yes;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [own, coupling] = shape_pair(d, i);
        answer = both(answer, is_positive(room(ray, 0, 0, 0) - ray.shear * (own + coupling)));
    }
    if (ray.bulk == 0) {
        return both(answer, is_above(ray.value, block, d, 0));
    }
    for (int n = 0; n <= slabs && answer == Answer::yes; ++n) {
        const int k = (n + slabs / 2) % (slabs + 1);  // z = 1/2 first: it fails first
        const double z = static_cast<double>(k) / slabs;
        const double last = std::min(1.0, z + 1.0 / slabs);
        const CellFunction bound = room(ray, z, 1.0 / slabs, last);
        const CellFunction along = ray.bulk * CellFunction{radial(z)};
        answer = both(answer, ray.shear == 0 ? is_above(bound, along) : is_above(bound, block, d, along));
    }
    return answer;
}

/// On the slab of this number. There F'_ii F'_jj = F'_ij F'_ji: a part of the coupling of each pair may move to the
/// block, whatever it is; the middle of the cell gives a good one. So a part that fails refutes nothing.
Answer is_stiffness_of_rank_one(const BoundRay& ray, const Direction& d, int slab) {
    if (ray.shear == 0) {
        return is_stiffness(ray, d);
    }
    const double first = static_cast<double>(slab) / slabs;
    const double last = static_cast<double>(slab + 1) / slabs;
    CellMatrix block = ray.shear * shape_block(d);
    bool proved = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const PairBlock pair = shape_pair(d, i);
        const CellFunction coupling = ray.shear * pair.coupling;
        const CellFunction left = room(ray, first, 0, 0) - ray.shear * pair.own;
        const double slack = std::max(0.0, left.centre.low - 0.003 * ray.value);
        const double wanted = -(block[i][j].centre.low + radial(first) * ray.bulk * d.product(i, j).centre.low);
        const double moved = std::clamp(wanted, coupling.centre.low - slack, coupling.centre.low + slack);
        proved = proved && is_positive(left - (coupling - moved)) == Answer::yes &&
                 is_positive(left + (coupling - moved)) == Answer::yes;
        block[i][j] = block[i][j] + moved;
        block[j][i] = block[i][j];
    }
    for (const double z : {first, last}) {
        proved = proved && is_above(room(ray, z, last - first, last), block, d, ray.bulk * CellFunction{radial(z)}) ==
                               Answer::yes;
    }
    return proved ? Answer::yes : Answer::unknown;
}

Answer is_negative_stiffness(const BoundRay& ray, const Direction& d) {
    const CellMatrix block = -ray.shear * shape_block(d);
    Answer answer = is_above(ray.value, block, d, 0);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [own, coupling] = shape_pair(d, i);
        answer = both(answer, is_positive(ray.value + ray.shear * (own - coupling)));
    }
    return answer;
}

/// The part with kappa is largest at z = 1/2 for every direction.
Answer is_damping(const BoundRay& ray, const Direction& d) {
    Answer answer = Answer::yes;
    CellMatrix block = zero_matrix();
    for (std::size_t i = 0; i < 3; ++i) {
        answer = both(answer, is_positive(ray.value - ray.shear * pair_of_damping(d, i)));
        for (std::size_t j = 0; j < 3; ++j) {
            block[i][j] = ray.shear * (-6.0 * (d.tt * d.product(i, j)));
        }
        block[i][i] = ray.shear * (12.0 * (d.tt * d.squared[i]));
    }
    return both(answer, ray.shear == 0 ? is_above(ray.value, ray.bulk) : is_above(ray.value, block, d, ray.bulk));
}

Answer holds(MeanStatement statement, const BoundRay& ray, const Direction& d, int slab) {
    switch (statement) {
        case MeanStatement::stiffness: return is_stiffness(ray, d);
        case MeanStatement::stiffness_of_rank_one: return is_stiffness_of_rank_one(ray, d, slab);
        case MeanStatement::negative_stiffness: return is_negative_stiffness(ray, d);
        case MeanStatement::damping: break;
    }
    return is_damping(ray, d);
}

struct Cell {
    double x;
    double y;
    double width;
};

/// Over all x and y from 0 to 1; the order of the stretches does not matter, so y > x is left out.
bool is_proved_on(int slab, MeanStatement statement, const BoundRay& ray) {
    constexpr double narrowest = 1e-4;
    std::vector<Cell> open{{0, 0, 1}};
    while (!open.empty()) {
        const auto [left, lower, width] = open.back();
        open.pop_back();
        if (lower > left + width) {
            continue;
        }
        const double half = width / 2;
        const CellFunction x{left + half, {left, left + width}, {1, 0}, half};
        const CellFunction y{lower + half, {lower, lower + width}, {0, 1}, half};
        if (holds(statement, ray, direction(x, y), slab) == Answer::yes) {
            continue;
        }
        const bool is_refuted = holds(statement, ray, direction(left + half, lower + half), slab) == Answer::no;
        if (is_refuted || width < narrowest) {
            return false;
        }
        for (const double dx : {half, 0.0}) {
            for (const double dy : {half, 0.0}) {
                open.push_back({left + dx, lower + dy, half});
            }
        }
    }
    return true;
}

}  // namespace

bool is_proved(MeanStatement statement, const physics::BoundRay& ray) {
    const bool is_by_slabs = statement == MeanStatement::stiffness_of_rank_one && ray.bulk > 0;
    bool proved = true;
    for (int slab = 0; slab < (is_by_slabs ? slabs : 1) && proved; ++slab) {
        proved = is_proved_on(slab, statement, ray);
    }
    return proved;
}

}  // namespace cracksim::test
