#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "surface/mass_marks.hpp"
#include "topology/gmap.hpp"

namespace cracksim::surface {

/// The free faces of this rank's owned entities, in the order in which they became free. None is ever removed: a free
/// face stays free.
class LocalSurface {
public:
    struct Face {
        LocalEntity entity;
        std::int8_t face;
        std::int32_t listed_in;  ///< the update that last changed it
        std::int32_t next;       ///< position in faces() of another face of the entity; -1: none
        double opened_at;        ///< s; -1 on the original boundary
    };

    /// opened_at(entity, face): when a free face that is not on the original boundary opened, s. owned must outlive
    /// this.
    LocalSurface(const topology::GMap& map, std::span<const std::uint8_t> owned,
                 const std::function<double(LocalEntity, int)>& opened_at);

    /// Records that a face was unsewn. update() must follow, with the corners of the face.
    void open(LocalEntity entity, int face, double time);
    /// Marks the free faces around the vertices at these corners as changed, because a vertex may have fallen apart.
    void update(const topology::GMap& map, std::span<const LocalMass> corners);

    /// Time of the split that opened a face, s; -1 if the face is sewn or on the original boundary.
    [[nodiscard]] double opened_at(LocalEntity entity, int face) const;
    [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
    /// Positions in faces() of new and changed faces, in the order of the changes. A face is listed once for each
    /// update that changes it. New faces are in the order of faces().
    [[nodiscard]] const std::vector<std::int32_t>& changed() const { return changed_; }

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// The position of a face in faces_; -1 if it is not listed.
    [[nodiscard]] std::int32_t place_of(LocalEntity entity, int face) const;
    std::int32_t list(LocalEntity entity, int face);
    Face& touch(LocalEntity entity, int face);
    void touch_around(const topology::GMap& map, LocalMass corner);

    std::span<const std::uint8_t> owned_;
    std::vector<Face> faces_;
    IdArray<LocalEntity, std::int32_t> last_face_;  ///< position of the entity's last face; -1: none
    std::vector<std::int32_t> changed_;
    std::int32_t updates_{1};
    MassMarks met_;  ///< masses that the current update has visited
    std::vector<LocalEntity> met_entities_;
};

}  // namespace cracksim::surface
