#include "physics/problem/single_precision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

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

/// The first number that is not fit, as text.
std::optional<std::string> first_unfit(std::span<const Number> numbers) {
    for (const Number& number : numbers) {
        if (!is_fit(number.value)) {
            return std::string{number.name} + ", " + rounded(number.value, 6) + " " + number.unit;
        }
    }
    return std::nullopt;
}

std::optional<std::string> unfit(const PaperEntity& entity, double step_size) {
    for (std::size_t i = 0; i < HexahedronPairs::count; ++i) {
        const double squared = entity.rest_length[i] * entity.rest_length[i];
        const auto& [stiffness, viscosity] = entity.interaction[i];
        const std::array numbers{
            Number{"the square of a rest length", squared, "m2"},
            Number{"the stiffness of an interaction", stiffness, "N/m"},
            Number{"the viscosity of an interaction over step and squared length", viscosity / (step_size * squared),
                   "N/m3"},
            Number{"the energy of an interaction stretched by its length", stiffness * squared, "J"}};
        if (auto found = first_unfit(numbers)) {
            return found;
        }
    }
    return std::nullopt;
}

std::optional<std::string> unfit(const StandardEntity& entity, double step_size) {
    const double energy = entity.bulk * entity.volume;
    const double stiffness = *std::ranges::max_element(entity.bending);
    const double steps = entity.solid.damping_time / step_size;
    const std::array numbers{Number{"the square of an edge", entity.edge.x * entity.edge.x, "m2"},
                             Number{"the square of an edge", entity.edge.y * entity.edge.y, "m2"},
                             Number{"the square of an edge", entity.edge.z * entity.edge.z, "m2"},
                             Number{"the bulk modulus times the volume of an entity", energy, "J"},
                             Number{"the bending stiffness of an entity", stiffness, "N/m"},
                             Number{"the damping time over the step", steps, ""},
                             Number{"the viscous energy of an entity", steps * energy, "J"}};
    return first_unfit(numbers);
}

}  // namespace

std::optional<std::string> unfit_for_single_precision(const EntityModel& model, double step_size) {
    const std::array mobility{
        Number{"the squared step over a mass", step_size * step_size / model.corner_mass, "s2/kg"}};
    if (auto found = first_unfit(mobility)) {
        return found;
    }
    return std::visit([&](const auto& entity) { return unfit(entity, step_size); }, model.law);
}

}  // namespace cracksim::physics
