#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cracksim::io {

/// Smallest number of insertions, deletions and substitutions of characters that turn one word into the other
/// (Levenshtein 1966).
[[nodiscard]] inline std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

/// The candidate with the smallest edit distance to the word; none if all distances are too large.
[[nodiscard]] inline std::optional<std::string_view> nearest(std::string_view word,
                                                             std::span<const std::string_view> candidates) {
    std::optional<std::string_view> best;
    std::size_t best_distance = (word.size() + 1) / 2 + 1;
    for (const std::string_view candidate : candidates) {
        if (const std::size_t distance = edit_distance(word, candidate); distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

/// The words as "a, b, c".
[[nodiscard]] inline std::string listed(std::span<const std::string_view> words) {
    std::string text;
    for (const std::string_view word : words) {
        text += (text.empty() ? "" : ", ") + std::string{word};
    }
    return text;
}

/// "did you mean 'b'?" or, if no word is near, "<otherwise> a, b, c".
[[nodiscard]] inline std::string suggestion(std::string_view word, std::span<const std::string_view> words,
                                            std::string_view otherwise) {
    if (const auto near = nearest(word, words)) {
        return "did you mean '" + std::string{*near} + "'?";
    }
    return std::string{otherwise} + " " + listed(words);
}

}  // namespace cracksim::io
