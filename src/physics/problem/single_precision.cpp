#include "physics/problem/single_precision.hpp"

#include <array>
#include <cmath>

#include "core/text.hpp"

namespace cracksim::physics {

namespace {

/// Single precision covers 1e-38 to 1e38. This limit leaves a margin for products with strains and increments.
constexpr double largest = 1e25;

struct Number {
    const char* name;
    double value;
    const char* unit;
};

bool is_fit(double value) { return value == 0 || (std::abs(value) < largest && std::abs(value) > 1 / largest); }

}  // namespace

std::optional<std::string> unfit_for_single_precision(const EntityModel& model, double step_size) {
    const double dt2_over_mass = step_size * step_size / model.corner_mass;
    for (std::size_t i = 0; i < HexahedronPairs::count; ++i) {
        const double squared = model.rest_length[i] * model.rest_length[i];
        const auto& [stiffness, viscosity] = model.interaction[i];
        const std::array numbers{
            Number{"the square of a rest length", squared, "m2"},
            Number{"the stiffness of an interaction", stiffness, "N/m"},
            Number{"the viscosity of an interaction over step and squared length", viscosity / (step_size * squared),
                   "N/m3"},
            Number{"the energy of an interaction stretched by its length", stiffness * squared, "J"},
            Number{"the squared step over a mass", dt2_over_mass, "s2/kg"}};
        for (const Number& number : numbers) {
            if (!is_fit(number.value)) {
                return std::string{number.name} + ", " + rounded(number.value, 6) + " " + number.unit;
            }
        }
    }
    return std::nullopt;
}

}  // namespace cracksim::physics
