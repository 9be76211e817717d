#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace cracksim::fuzz {

/// Ends the campaign with the input at hand unless the condition holds.
inline void require(bool condition, const char* what) {
    if (!condition) {
        std::fprintf(stderr, "finding: %s\n", what);
        std::abort();
    }
}

/// What every message for users owes them.
inline void require_good_message(std::string_view message) {
    constexpr std::size_t longest = 1200;
    require(!message.empty() && message.size() <= longest, "a message is empty, or longer than anyone reads");
    require(std::ranges::none_of(message, [](unsigned char c) { return c < 0x20 || c == 0x7f; }),
            "a message has control characters or more than one line");
}

}  // namespace cracksim::fuzz
