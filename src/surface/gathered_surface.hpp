#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/block.hpp"
#include "core/ids.hpp"
#include "geometry/mesh.hpp"
#include "surface/surface_update.hpp"

namespace cracksim::surface {

/// The surface of the whole block, which the root assembles from the updates of all ranks and keeps between frames. Its
/// meshes equal those of surface_mesh(). Their order follows the keys and does not depend on the ranks. No
/// communication.
class GatheredSurface {
public:
    GatheredSurface(const Block& block, std::size_t ranks);

    /// Applies the updates of all ranks for the next frame.
    void take(std::span<const SurfaceUpdate> update);

    [[nodiscard]] const geometry::Mesh& surface() const { return surface_; }
    /// The mesh of the crack faces of surface() and of the points that they use.
    [[nodiscard]] const geometry::Mesh& crack();

private:
    using Places = std::vector<std::int32_t>;
    /// The positions in surface_ of a rank's points and faces, in the rank's own order.
    struct Order {
        Places point;
        Places face;
    };

    void add_points(std::span<const SurfaceUpdate> update);
    void add_faces(std::span<const SurfaceUpdate> update);
    void make_room(const Places& moved);
    void set_face(const SurfaceUpdate::Face& face);
    void set_met(const SurfaceUpdate::Face& face);
    void find_crack();
    void number_crack_points();
    void move(std::span<const SurfaceUpdate> update);
    void name_fragments(std::span<const SurfaceUpdate> update);
    void measure_openings();
    void measure_opening(std::int32_t face, std::int32_t other);
    [[nodiscard]] std::size_t place_of(std::int64_t face_key) const;
    [[nodiscard]] std::vector<double>& reals(std::size_t field);
    [[nodiscard]] std::vector<std::int64_t>& integers(std::size_t field);

    Block block_;
    std::vector<Order> orders_;
    std::vector<MassId> point_keys_;
    std::vector<std::int64_t> face_keys_;
    geometry::Mesh surface_;
    bool crack_is_old_{true};
    Places crack_faces_;
    Places crack_points_;
    Places met_;  ///< by face: position of the other side of a crack face; -1 on the original boundary
    geometry::Mesh crack_;
};

}  // namespace cracksim::surface
