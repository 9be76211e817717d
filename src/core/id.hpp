#pragma once

#include <compare>
#include <cstddef>
#include <functional>

namespace cracksim {

/// A strongly typed integer id: ids with different Tags do not mix, and arithmetic needs value().
template <class Tag, class Rep>
class Id {
public:
    using value_type = Rep;

    constexpr Id() = default;
    constexpr explicit Id(Rep value) : value_{value} {}

    [[nodiscard]] constexpr Rep value() const { return value_; }
    /// The id as a container index. Requires a value of zero or more.
    [[nodiscard]] constexpr std::size_t index() const { return static_cast<std::size_t>(value_); }

    constexpr Id& operator++() {
        ++value_;
        return *this;
    }
    friend constexpr auto operator<=>(Id, Id) = default;

private:
    Rep value_{-1};
};

}  // namespace cracksim

template <class Tag, class Rep>
struct std::hash<cracksim::Id<Tag, Rep>> {
    std::size_t operator()(cracksim::Id<Tag, Rep> id) const noexcept { return std::hash<Rep>{}(id.value()); }
};
