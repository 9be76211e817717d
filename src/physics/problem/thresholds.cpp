#include "physics/problem/thresholds.hpp"

#include <cmath>

#include "core/hash.hpp"

namespace cracksim::physics {

namespace {

double factor(const Weibull& weibull, std::int64_t id_a, std::int64_t id_b) {
    const std::uint64_t random =
        mix(mix(mix(weibull.seed), static_cast<std::uint64_t>(id_a)), static_cast<std::uint64_t>(id_b));
    const double exponent = 1.0 / weibull.shape;
    return std::pow(-std::log(unit_interval(random)), exponent) / std::tgamma(1.0 + exponent);
}

}  // namespace

double weibull_factor(const Weibull& weibull, MassId mass_a, MassId mass_b) {
    return factor(weibull, mass_a.value(), mass_b.value());
}

double weibull_factor(const Weibull& weibull, EntityId entity_a, EntityId entity_b) {
    return factor(weibull, entity_a.value(), entity_b.value());
}

double Thresholds::of(MassId mass_a, MassId mass_b, Vec3 rest_position) const {
    const double threshold = field(rest_position);
    return weibull ? threshold * weibull_factor(*weibull, mass_a, mass_b) : threshold;
}

double Thresholds::of(EntityId entity_a, EntityId entity_b, Vec3 face_centre) const {
    const double threshold = field(face_centre);
    return weibull ? threshold * weibull_factor(*weibull, entity_a, entity_b) : threshold;
}

}  // namespace cracksim::physics
