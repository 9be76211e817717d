#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/hexahedron.hpp"
#include "core/ids.hpp"

namespace cracksim::physics {

/// A duplet on this rank: 4 * interior face + k, where k is the place of its first mass in the face's cycle.
using LocalDuplet = Id<struct LocalDupletTag, std::int32_t>;

constexpr int duplets_per_face = Hexahedron::face_corners;

[[nodiscard]] constexpr LocalDuplet local_duplet(std::int32_t interior_face, int k) {
    return LocalDuplet{interior_face * duplets_per_face + k};
}
[[nodiscard]] constexpr std::int32_t interior_face_of(LocalDuplet d) { return d.value() / duplets_per_face; }
[[nodiscard]] constexpr int place_of(LocalDuplet d) { return d.value() % duplets_per_face; }

/// The choice of the duplets that tie the masses that meet at a vertex.
enum class DupletKind : std::uint8_t {
    corners,  ///< one duplet at each corner of each shared face
    tree      ///< of these, only those of a spanning tree of each union, found breadth first by ascending id
};

/// A duplet and the mass at its other end.
struct Tie {
    LocalDuplet duplet;
    LocalMass mass;
};

/// A set of duplets of this rank: one bit for each duplet that an interior face can have.
class DupletSet {
public:
    DupletSet() = default;
    /// The empty set.
    explicit DupletSet(std::size_t interior_faces) : of_face_(interior_faces, 0) {}

    [[nodiscard]] bool contains(LocalDuplet d) const { return (unsigned{of_face_[face(d)]} & bit(d)) != 0; }
    void insert(LocalDuplet d) { of_face_[face(d)] = static_cast<std::uint8_t>(of_face_[face(d)] | bit(d)); }
    void erase(LocalDuplet d) { of_face_[face(d)] = static_cast<std::uint8_t>(of_face_[face(d)] & ~bit(d)); }
    /// Bit k is set where duplet k of an interior face is in the set.
    [[nodiscard]] std::uint8_t of_face(std::int32_t interior_face) const {
        return of_face_[static_cast<std::size_t>(interior_face)];
    }
    [[nodiscard]] std::size_t interior_faces() const { return of_face_.size(); }
    /// Calls action(duplet) for the duplets of the set, ascending.
    template <class Action>
    void for_each(Action&& action) const {
        for (std::int32_t f = 0; f < static_cast<std::int32_t>(of_face_.size()); ++f) {
            for (int k = 0; of_face(f) != 0 && k < duplets_per_face; ++k) {
                if (contains(local_duplet(f, k))) {
                    action(local_duplet(f, k));
                }
            }
        }
    }
    [[nodiscard]] std::size_t memory_bytes() const { return of_face_.capacity(); }

    friend bool operator==(const DupletSet&, const DupletSet&) = default;

private:
    [[nodiscard]] static std::size_t face(LocalDuplet d) { return static_cast<std::size_t>(interior_face_of(d)); }
    [[nodiscard]] static unsigned bit(LocalDuplet d) { return 1U << static_cast<unsigned>(place_of(d)); }

    std::vector<std::uint8_t> of_face_;
};

}  // namespace cracksim::physics
