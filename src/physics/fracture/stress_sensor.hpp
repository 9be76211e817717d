#pragma once

#include <array>

#include "core/symmetric_tensor.hpp"
#include "core/vec3.hpp"

namespace cracksim::physics {

// The sensor `stress` decides about an interior face from the stresses of its two entities. All functions compute with
// + - * / and sqrt only, so their bits are the same on every machine.

/// Eigenvalues and the components of their unit eigenvectors: vector[i] belongs to value[i], in no special order.
struct Eigenpairs {
    std::array<double, 3> value;
    std::array<Vec3, 3> vector;

    [[nodiscard]] double largest() const;
};

/// By six cyclic sweeps of Jacobi rotations, which converge quadratically; more would change nothing.
[[nodiscard]] Eigenpairs eigenpairs(const SymmetricTensor& tensor);

/// True only if all eigenvalues are at most the bound: bound I - tensor has pivots > 0, > 0 and >= 0.
[[nodiscard]] bool is_bounded(const SymmetricTensor& tensor, double bound);

/// True if a face opens. a, b: stresses of its two entities along the rest axes, over Young's modulus; axis: that of
/// the face's normal; threshold s: a stretch. With M = (a + b)/2, its eigenpairs l_i, v_i and the largest eigenvalue
/// l_1(.) of a tensor,
///
///     r_j = sum over l_i > 0 of l_i^2 (v_i)_j^2,   lambda = 3/4 l_1(M) + 1/4 min(l_1(a), l_1(b)),
///
/// it opens if l_1(M) > 0 and lambda r_axis > s max_j r_j. The same bits if a and b swap.
[[nodiscard]] bool opens(const SymmetricTensor& a, const SymmetricTensor& b, int axis, double threshold);

}  // namespace cracksim::physics
