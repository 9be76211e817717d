#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace cracksim::topology {

/// A vector that stores up to N elements inside the object, so that the orbits of a block need no allocation. It moves
/// to the heap when it grows beyond N.
template <class T, std::size_t N>
class InlineVector {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] const T* begin() const { return heap_.empty() ? inline_.data() : heap_.data(); }
    [[nodiscard]] const T* end() const { return begin() + size_; }
    [[nodiscard]] const T& operator[](std::size_t i) const { return begin()[i]; }
    [[nodiscard]] bool contains(const T& value) const { return std::find(begin(), end(), value) != end(); }

    void push_back(T value) {
        if (size_ < N) {
            inline_[size_] = value;
        } else {
            if (heap_.empty()) {
                heap_.assign(inline_.begin(), inline_.end());
            }
            heap_.push_back(value);
        }
        ++size_;
    }
    /// Appends the value unless the vector contains it already. The cost is linear in the size.
    void insert(T value) {
        if (!contains(value)) {
            push_back(value);
        }
    }

private:
    std::size_t size_{0};
    std::array<T, N> inline_{};
    std::vector<T> heap_;
};

}  // namespace cracksim::topology
