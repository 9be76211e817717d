#include "physics/problem/thresholds.hpp"

#include <cmath>

#include "core/hash.hpp"

namespace cracksim::physics {

double weibull_factor(const Weibull& weibull, MassId mass_a, MassId mass_b) {
    const std::uint64_t random = mix(mix(mix(weibull.seed), static_cast<std::uint64_t>(mass_a.value())),
                                     static_cast<std::uint64_t>(mass_b.value()));
    const double exponent = 1.0 / weibull.shape;
    return std::pow(-std::log(unit_interval(random)), exponent) / std::tgamma(1.0 + exponent);
}

double Thresholds::of(MassId mass_a, MassId mass_b, Vec3 rest_position) const {
    const double threshold = field(rest_position);
    return weibull ? threshold * weibull_factor(*weibull, mass_a, mass_b) : threshold;
}

}  // namespace cracksim::physics
