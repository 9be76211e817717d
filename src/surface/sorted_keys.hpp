#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/contracts.hpp"
#include "core/sorted.hpp"

namespace cracksim::surface {

// Columns of values in the order of their keys.

/// Puts new keys (ascending, none there yet) among ascending ones. Returns where the old ones stand now.
template <class Key>
std::vector<std::int32_t> merge(std::vector<Key>& keys, const std::vector<Key>& added) {
    std::vector<std::int32_t> moved(keys.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        while (next < added.size() && added[next] < keys[i]) {
            ++next;
        }
        moved[i] = static_cast<std::int32_t>(i + next);
    }
    const auto old = static_cast<std::ptrdiff_t>(keys.size());
    keys.insert(keys.end(), added.begin(), added.end());
    std::inplace_merge(keys.begin(), keys.begin() + old, keys.end());
    return moved;
}

/// Values follow their keys; those of new keys are still to be set. From the end, so that none is overwritten.
template <class T>
void spread(std::vector<T>& values, const std::vector<std::int32_t>& moved, std::size_t size, std::size_t columns) {
    values.resize(size * columns);
    for (std::size_t i = moved.size(); i > 0 && static_cast<std::size_t>(moved[i - 1]) != i - 1; --i) {
        const auto from = values.begin() + static_cast<std::ptrdiff_t>((i - 1) * columns);
        const auto to =
            values.begin() + static_cast<std::ptrdiff_t>(moved[i - 1]) * static_cast<std::ptrdiff_t>(columns);
        std::copy_backward(from, from + static_cast<std::ptrdiff_t>(columns),
                           to + static_cast<std::ptrdiff_t>(columns));
    }
}

/// Places follow what they name; negative ones name nothing.
inline void rename(std::vector<std::int32_t>& places, const std::vector<std::int32_t>& moved) {
    for (std::int32_t& place : places) {
        place = place < 0 ? place : moved[static_cast<std::size_t>(place)];
    }
}

template <class Key>
std::int32_t place_in(const std::vector<Key>& keys, const Key& key) {
    const auto found = std::ranges::lower_bound(keys, key);
    CRACKSIM_ASSERT(found != keys.end() && *found == key);
    return static_cast<std::int32_t>(found - keys.begin());
}

/// Ascending, each once, without those that are there.
template <class Key>
void keep_new(std::vector<Key>& keys, const std::vector<Key>& there) {
    sort_and_make_unique(keys);
    std::erase_if(keys, [&](const Key& key) { return std::ranges::binary_search(there, key); });
}

template <class T>
void pick(const std::vector<T>& from, const std::vector<std::int32_t>& places, std::vector<T>& picked) {
    picked.resize(places.size());
    std::ranges::transform(places, picked.begin(), [&](std::int32_t i) { return from[static_cast<std::size_t>(i)]; });
}

}  // namespace cracksim::surface
