#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cracksim {

/// A vector that is indexed by one kind of id only.
template <class Id, class T>
class IdArray {
public:
    IdArray() = default;
    explicit IdArray(std::size_t size, const T& value = T{}) : data_(size, value) {}
    explicit IdArray(std::vector<T> data) : data_{std::move(data)} {}

    [[nodiscard]] T& operator[](Id id) { return data_[id.index()]; }
    [[nodiscard]] const T& operator[](Id id) const { return data_[id.index()]; }
    [[nodiscard]] std::size_t size() const { return data_.size(); }
    [[nodiscard]] bool empty() const { return data_.empty(); }
    [[nodiscard]] std::size_t bytes() const { return data_.capacity() * sizeof(T); }
    [[nodiscard]] std::span<T> span() { return data_; }
    [[nodiscard]] std::span<const T> span() const { return data_; }
    [[nodiscard]] auto begin() { return data_.begin(); }
    [[nodiscard]] auto end() { return data_.end(); }
    [[nodiscard]] auto begin() const { return data_.begin(); }
    [[nodiscard]] auto end() const { return data_.end(); }

private:
    std::vector<T> data_;
};

/// The index of a global id in an ascending list, if it is there.
template <class Local, class Global>
[[nodiscard]] std::optional<Local> find_local(const IdArray<Local, Global>& ascending, Global id) {
    const auto place = std::lower_bound(ascending.begin(), ascending.end(), id);
    if (place == ascending.end() || *place != id) {
        return std::nullopt;
    }
    return Local{static_cast<typename Local::value_type>(place - ascending.begin())};
}

}  // namespace cracksim
