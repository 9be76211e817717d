#pragma once

namespace cracksim::test {

/// True in sanitized builds, which are slow: tests with many random scenes take fewer of them.
constexpr bool is_quick = CRACKSIM_QUICK_TESTS;

}  // namespace cracksim::test
