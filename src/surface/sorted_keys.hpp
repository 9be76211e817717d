#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/contracts.hpp"
#include "core/sorted.hpp"

namespace cracksim::surface {

// Columns of values that are sorted by their keys.

/// Merges new keys (ascending, none of them in `keys`) into ascending keys. Returns the new position of each old key.
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

/// Moves values to the new positions of their keys; the values of new keys remain to be set. Moves the last value
/// first, so that no value is overwritten before it is moved.
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

/// Replaces old positions by new ones; negative positions mean none and stay unchanged.
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

/// Sorts the keys and removes repeated keys and keys that `there` (ascending) contains.
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
