#pragma once

#include <cstdint>

#include "core/contracts.hpp"
#include "core/ids.hpp"

namespace cracksim::topology {

/// The face to which a face was sewn at construction, in 4 bytes: a face of a local entity, a face of an entity that is
/// not local (remote), or none (the block's boundary). Face corner k meets corner (rotation - k) mod 4 of the other
/// face.
class FaceLink {
public:
    /// Number of local entities that a link can address.
    static constexpr std::int32_t entity_limit = std::int32_t{1} << 26;

    [[nodiscard]] static constexpr FaceLink boundary() { return FaceLink{-1}; }
    [[nodiscard]] static constexpr FaceLink remote() { return FaceLink{-2}; }
    [[nodiscard]] static constexpr FaceLink local(LocalEntity entity, int face, int rotation) {
        CRACKSIM_EXPECT(entity.value() >= 0 && entity.value() < entity_limit);
        CRACKSIM_EXPECT(face >= 0 && face < 8 && rotation >= 0 && rotation < 4);
        return FaceLink{entity.value() * 32 + face * 4 + rotation};
    }

    [[nodiscard]] constexpr bool is_boundary() const { return code_ == -1; }
    [[nodiscard]] constexpr bool is_local() const { return code_ >= 0; }

    /// The entity on the other side. Requires is_local(), as do face() and rotation().
    [[nodiscard]] constexpr LocalEntity entity() const { return LocalEntity{code_ / 32}; }
    [[nodiscard]] constexpr int face() const { return code_ / 4 % 8; }
    [[nodiscard]] constexpr int rotation() const { return code_ % 4; }

    friend constexpr bool operator==(FaceLink, FaceLink) = default;

private:
    constexpr explicit FaceLink(std::int32_t code) : code_{code} {}

    std::int32_t code_;
};

static_assert(sizeof(FaceLink) == 4);

/// The edge of the other face that edge k meets over a link, in the opposite direction: edge k joins corners k and
/// k + 1, which meet corners rotation - k and rotation - k - 1.
[[nodiscard]] constexpr int edge_met(int rotation, int k, int face_corners) {
    return (rotation - k - 1 + 2 * face_corners) % face_corners;
}

}  // namespace cracksim::topology
