#include "io/expression.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/errors.hpp"
#include "fuzz/finding.hpp"

namespace {

using namespace cracksim;

bool same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

void check(const io::Expression& expression) {
    struct Point {
        Vec3 at;
        double time;
    };
    constexpr std::array<Point, 3> points{{{{0, 0, 0}, 0}, {{-0.5, 1e3, 2}, 0.1}, {{1e300, -1e300, 1e-300}, 7}}};
    const io::Expression again{expression.text()};
    for (const auto& [at, time] : points) {
        const double value = expression(at, time);
        fuzz::require(same(value, expression(at, time)), "an expression changes its value");
        fuzz::require(same(value, again(at, time)), "an expression's text reads back as another one");
        fuzz::require(!expression.is_constant() || same(value, expression({3, 4, 5}, 6)), "a constant varies");
        fuzz::require(expression.uses_time() || same(value, expression(at, time + 1)), "time is used, but not known");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        check(io::Expression{std::string{reinterpret_cast<const char*>(data), size}});
    } catch (const InputError& error) {
        fuzz::require_good_message(error.what());
    }
    return 0;
}
