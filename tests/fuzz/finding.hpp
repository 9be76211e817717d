#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace cracksim::fuzz {

/// Aborts unless the condition holds; libFuzzer then keeps the current input as a finding.
inline void require(bool condition, const char* what) {
    if (!condition) {
        std::fprintf(stderr, "finding: %s\n", what);
        std::abort();
    }
}

/// Checks that a message for users has one line of reasonable length without control characters.
inline void require_good_message(std::string_view message) {
    constexpr std::size_t longest = 1200;
    require(!message.empty() && message.size() <= longest, "a message is empty, or longer than anyone reads");
    require(std::ranges::none_of(message, [](unsigned char c) { return c < 0x20 || c == 0x7f; }),
            "a message has control characters or more than one line");
}

}  // namespace cracksim::fuzz
