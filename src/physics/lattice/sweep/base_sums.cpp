#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/lattice/sweep/base_sums.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "physics/lattice/sweep/base_sums.hpp"
#include "physics/lattice/sweep/vectors-inl.hpp"
#include "physics/state/motion.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

using Double = D<double>;
using Doubles = V<double>;

HWY_INLINE Doubles load_doubles(const double* from) { return hn::Load(Double{}, from); }
HWY_INLINE Doubles load_doubles(const float* from) {
    return hn::PromoteTo(Double{}, hn::Load(hn::Rebind<float, Double>{}, from));
}

struct BaseSums {
    Doubles kinetic;
    Doubles momentum[3];
    Doubles angular_momentum[3];
};

/// Adds the unions at the place `at` of a row; without a mass, there is none.
template <class Real>
HWY_INLINE void add_unions(const BaseSumsView<Real>& v, std::size_t at, Doubles along, BaseSums& sums) {
    const Double d;
    const auto load = [&](std::size_t quantity) { return load_doubles(v.base + quantity * v.base_stride + at); };
    const Doubles dt2_over_mass = load(Quantity::dt2_over_mass);
    const auto any = hn::Gt(dt2_over_mass, hn::Zero(d));
    const Doubles half_mass = hn::IfThenElseZero(any, hn::Div(hn::Set(d, 0.5), dt2_over_mass));
    Doubles position[3];
    Doubles momentum[3];
    Doubles product = hn::Zero(d);
    for (std::size_t i = 0; i < 3; ++i) {
        const Doubles last = load(Quantity::increment + i);
        const Doubles next = hn::MulAdd(dt2_over_mass, load(Quantity::force + i), last);
        product = hn::MulAdd(last, next, product);
        momentum[i] = hn::Mul(half_mass, hn::Add(last, next));
        sums.momentum[i] = hn::Add(sums.momentum[i], momentum[i]);
        position[i] = hn::Add(i == 0 ? along : hn::Set(d, v.rest[i]), load(Quantity::displacement + i));
    }
    sums.kinetic = hn::MulAdd(half_mass, product, sums.kinetic);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        sums.angular_momentum[i] =
            hn::NegMulAdd(position[k], momentum[j], hn::MulAdd(position[j], momentum[k], sums.angular_momentum[i]));
    }
}

template <class Real>
void add_row(BaseSumsView<Real>& v) {
    const Double d;
    const Doubles zero = hn::Zero(d);
    BaseSums sums{zero, {zero, zero, zero}, {zero, zero, zero}};
    Doubles along = hn::MulAdd(hn::Set(d, v.edge), hn::Iota(d, 0.0), hn::Set(d, v.rest[0]));
    const Doubles further = hn::Set(d, v.edge * static_cast<double>(hn::Lanes(d)));
    for (std::size_t at = 0; at < v.length; at += hn::Lanes(d)) {
        add_unions(v, at, along, sums);
        along = hn::Add(along, further);
    }
    const auto sum = [&](Doubles lanes) { return hn::GetLane(hn::SumOfLanes(d, lanes)); };
    v.kinetic += sum(sums.kinetic);
    for (std::size_t i = 0; i < 3; ++i) {
        v.momentum[i] += sum(sums.momentum[i]);
        v.angular_momentum[i] += sum(sums.angular_momentum[i]);
    }
}

void add_base_sums_double(BaseSumsView<double>& v) { add_row(v); }
void add_base_sums_single(BaseSumsView<float>& v) { add_row(v); }

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(add_base_sums_double);
HWY_EXPORT(add_base_sums_single);

void add_base_sums(BaseSumsView<double>& v) { HWY_DYNAMIC_DISPATCH(add_base_sums_double)(v); }
void add_base_sums(BaseSumsView<float>& v) { HWY_DYNAMIC_DISPATCH(add_base_sums_single)(v); }

}  // namespace cracksim::physics

#endif
