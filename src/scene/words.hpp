#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "core/contracts.hpp"
#include "scene/scene.hpp"

namespace cracksim::scene {

/// The words of the format for the enumerators of a key.
template <class Enum, std::size_t Size>
using Words = std::array<std::pair<std::string_view, Enum>, Size>;

inline constexpr Words<MaterialModel, 2> material_models{
    {{"standard", MaterialModel::standard}, {"paper", MaterialModel::paper}}};
inline constexpr Words<physics::SensorKind, 2> sensor_kinds{
    {{"normal", physics::SensorKind::normal}, {"stress", physics::SensorKind::stress}}};

template <class Enum, std::size_t Size>
[[nodiscard]] std::string word_of(Enum value, const Words<Enum, Size>& words) {
    const auto found = std::ranges::find(words, value, [](const auto& word) { return word.second; });
    CRACKSIM_EXPECT(found != words.end());
    return std::string{found->first};
}

}  // namespace cracksim::scene
