#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/vec3.hpp"

namespace cracksim::physics {

/// Three components of a vector quantity, each an array of its own.
class Field {
public:
    void resize(std::size_t size) {
        for (auto& c : component_) {
            c.resize(size, 0.0);
        }
    }
    [[nodiscard]] std::size_t size() const { return component_[0].size(); }
    [[nodiscard]] double* component(int axis) { return component_[static_cast<std::size_t>(axis)].data(); }
    [[nodiscard]] const double* component(int axis) const { return component_[static_cast<std::size_t>(axis)].data(); }
    [[nodiscard]] Vec3 operator[](std::size_t i) const {
        return {component_[0][i], component_[1][i], component_[2][i]};
    }
    void set(std::size_t i, Vec3 value) {
        component_[0][i] = value.x;
        component_[1][i] = value.y;
        component_[2][i] = value.z;
    }
    [[nodiscard]] std::size_t memory_bytes() const { return 3 * component_[0].capacity() * sizeof(double); }

private:
    std::array<std::vector<double>, 3> component_;
};

}  // namespace cracksim::physics
