#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/block.hpp"
#include "core/contracts.hpp"
#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "physics/problem/duplets.hpp"
#include "physics/problem/entity_model.hpp"
#include "physics/problem/interior_faces.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/problem/notch.hpp"
#include "physics/problem/sensor_kind.hpp"
#include "physics/problem/support.hpp"
#include "physics/problem/thresholds.hpp"

namespace cracksim::physics {

/// The data from which a network is built.
struct NetworkParts {
    Block block;
    EntityModel model;
    IdArray<LocalEntity, EntityId> entities;   ///< the local entities, ascending
    IdArray<LocalEntity, std::uint8_t> owned;  ///< 1 if this rank owns the entity
    DupletKind duplets{DupletKind::corners};
    SensorKind sensors{SensorKind::normal};
    Thresholds thresholds;
    std::vector<Support> supports;
    std::vector<Notch> notches;
};

/// The problem on this rank: entities, duplets and their thresholds, supports, notches. It never changes during a run.
/// The masses that meet at a vertex form one starting union, or several if notches separate them; both kinds of duplets
/// give the same starting unions.
class Network {
public:
    /// An invalid threshold does not throw, because all ranks must throw the same error: see invalid_threshold().
    explicit Network(NetworkParts parts);

    [[nodiscard]] const Block& block() const { return block_; }
    [[nodiscard]] const EntityModel& model() const { return model_; }
    [[nodiscard]] std::int32_t entity_count() const { return static_cast<std::int32_t>(entities_.size()); }
    [[nodiscard]] std::int32_t mass_count() const { return entity_count() * Hexahedron::corners; }
    /// Ascending.
    [[nodiscard]] const IdArray<LocalEntity, EntityId>& entities() const { return entities_; }
    [[nodiscard]] EntityId entity(LocalEntity e) const { return entities_[e]; }
    [[nodiscard]] bool owned(LocalEntity e) const { return owned_[e] != 0; }
    [[nodiscard]] MassId mass(LocalMass m) const { return mass_id(entities_[entity_of(m)], corner_of(m)); }
    [[nodiscard]] Vec3 rest_position(LocalMass m) const {
        return block_.position(entities_[entity_of(m)], corner_of(m));
    }

    [[nodiscard]] const InteriorFaces& interior_faces() const { return interior_faces_; }
    /// The interior faces that notches open, ascending. No duplet ties their corners.
    [[nodiscard]] const std::vector<std::int32_t>& notched_faces() const { return notched_faces_; }
    /// The number of interior faces that each notch crosses, counted by the owner of the smaller entity.
    [[nodiscard]] const std::vector<std::int64_t>& faces_of_notches() const { return faces_of_notches_; }
    [[nodiscard]] bool is_notched(std::int32_t interior_face) const;

    /// The id of the duplet that ties a mass to the mass that meets it across a face of its entity, whether or not the
    /// duplet exists. None if the face is not an interior face or the mass is not on it.
    [[nodiscard]] std::optional<LocalDuplet> duplet_over(LocalMass m, int face) const {
        const LocalEntity e = entity_of(m);
        const std::int32_t index = interior_faces_.at(e, face);
        if (index < 0) {
            return std::nullopt;
        }
        const InteriorFace& shared = interior_faces_[index];
        const int k = shared.a == e ? shared.place_of_a(corner_of(m)) : shared.place_of_b(corner_of(m));
        return k < 0 ? std::nullopt : std::optional{local_duplet(index, k)};
    }
    /// The same duplet with the mass at its other end.
    [[nodiscard]] std::optional<Tie> tie_over(LocalMass m, int face) const;
    /// The duplets that exist and tie masses of touched unions.
    [[nodiscard]] const DupletSet& duplets() const { return duplets_; }
    [[nodiscard]] SensorKind sensors() const { return sensors_; }
    /// Sensors `normal`: threshold, a stretch, of a duplet in duplets().
    [[nodiscard]] double threshold(LocalDuplet d) const {
        CRACKSIM_EXPECT(sensors_ == SensorKind::normal && duplets_.contains(d));
        return threshold_.empty() ? uniform_threshold_ : threshold_[d.index()];
    }
    /// Sensors `stress`: threshold, a stretch, of an interior face that has a duplet in duplets().
    [[nodiscard]] double face_threshold(std::int32_t interior_face) const {
        CRACKSIM_EXPECT(sensors_ == SensorKind::stress && duplets_.of_face(interior_face) != 0);
        return threshold_.empty() ? uniform_threshold_ : threshold_[static_cast<std::size_t>(interior_face)];
    }
    /// The lowest threshold on this rank; infinite if it has no sensor.
    [[nodiscard]] double lowest_threshold() const { return lowest_threshold_; }
    /// The masses that a duplet ties; the first has the smaller id.
    [[nodiscard]] std::array<LocalMass, 2> masses_of(LocalDuplet d) const {
        const InteriorFace& shared = interior_faces_[interior_face_of(d)];
        return {local_mass(shared.a, shared.corner_a(place_of(d))), local_mass(shared.b, shared.corner_b(place_of(d)))};
    }

    [[nodiscard]] const Lattice& lattice() const { return *lattice_; }
    /// The same lattice; its address does not change if the network is moved.
    [[nodiscard]] const std::shared_ptr<const Lattice>& shared_lattice() const { return lattice_; }
    /// Calls action(masses) for each touched vertex, that is, each vertex where this rank owns a mass. masses: all
    /// masses that meet there, ascending; all of them are local.
    template <class Action>
    void for_each_touched_vertex(Action&& action) const {
        for_each_vertex([&](std::span<const LocalMass> masses, bool touched) {
            if (touched) {
                action(masses);
            }
        });
    }
    /// The local masses at vertices that are not touched, ascending. The owners of their entities send their motion.
    [[nodiscard]] const std::vector<LocalMass>& received() const { return received_; }
    [[nodiscard]] const std::vector<Support>& supports() const { return supports_; }

    /// Describes a threshold on this rank that is not a number or not above zero, if there is one.
    [[nodiscard]] const std::optional<std::string>& invalid_threshold() const { return invalid_threshold_; }

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void find_received();
    /// Calls action(masses, touched) for each vertex with local masses. masses: these masses, ascending.
    template <class Action>
    void for_each_vertex(Action&& action) const {
        std::vector<LocalMass> masses;
        const auto count = static_cast<std::int32_t>(lattice_->vertex_sites());
        for (VertexSite v{0}; v.value() < count; ++v) {
            masses.clear();
            bool touched = false;
            lattice_->for_each_mass_at(v, [&](LocalMass m) {
                masses.push_back(m);
                touched = touched || owned(entity_of(m));
            });
            if (!masses.empty()) {
                action(std::span<const LocalMass>{masses}, touched);
            }
        }
    }
    void find_notched_faces(const std::vector<Notch>& notches);
    void find_duplets(DupletKind kind);
    void add_ties(std::span<const LocalMass> masses);
    void add_tree(LocalMass root, std::vector<LocalMass>& reached);
    void set_thresholds(const Thresholds& thresholds);
    void set_face_thresholds(const Thresholds& thresholds);
    [[nodiscard]] Vec3 centre(const InteriorFace& face) const;
    void set_threshold(std::size_t sensor, std::size_t sensors, double threshold, Vec3 at, bool is_first);

    Block block_;
    EntityModel model_;
    IdArray<LocalEntity, EntityId> entities_;
    IdArray<LocalEntity, std::uint8_t> owned_;
    std::shared_ptr<const Lattice> lattice_;
    std::vector<Support> supports_;
    InteriorFaces interior_faces_;
    std::vector<std::int32_t> notched_faces_;
    std::vector<std::int64_t> faces_of_notches_;
    DupletSet duplets_;
    SensorKind sensors_;
    /// By duplet, or by interior face for sensors `stress`; empty: all are uniform_threshold_.
    std::vector<double> threshold_;
    double uniform_threshold_{0};
    double lowest_threshold_{std::numeric_limits<double>::infinity()};
    std::vector<LocalMass> received_;
    std::optional<std::string> invalid_threshold_;
};

}  // namespace cracksim::physics
