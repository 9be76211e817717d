#pragma once

namespace cracksim::test {

/// Sanitized runs are slow: tests of many drawn scenes take fewer of them there.
constexpr bool is_quick = CRACKSIM_QUICK_TESTS;

}  // namespace cracksim::test
