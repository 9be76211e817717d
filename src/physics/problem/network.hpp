#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/block.hpp"
#include "core/contracts.hpp"
#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "physics/problem/entity_model.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/problem/thresholds.hpp"

namespace cracksim::physics {

/// A duplet on this rank: 4 * interior face + k.
using LocalDuplet = Id<struct LocalDupletTag, std::int32_t>;

/// Two entities that share a face. Duplet k ties the masses at corner k of a's face and at the corner it meets on b's.
/// a is the smaller entity.
struct InteriorFace {
    LocalEntity a;
    LocalEntity b;
    std::uint8_t face_a;
    std::uint8_t face_b;
    std::uint8_t rotation;

    [[nodiscard]] int corner_a(int k) const { return Hexahedron::face[face_a][static_cast<std::size_t>(k)]; }
    [[nodiscard]] int corner_b(int k) const {
        return Hexahedron::face[face_b][static_cast<std::size_t>(partner_place(k))];
    }
    /// The k of the duplet at a corner of a (or of b), or -1 if the corner is not on the face.
    [[nodiscard]] int duplet_at_a(int corner) const { return Hexahedron::place_in_face(face_a, corner); }
    [[nodiscard]] int duplet_at_b(int corner) const {
        const int place = Hexahedron::place_in_face(face_b, corner);
        return place < 0 ? -1 : partner_place(place);
    }

private:
    [[nodiscard]] int partner_place(int k) const {
        return (rotation - k + 2 * Hexahedron::face_corners) % Hexahedron::face_corners;
    }
};

/// Prescribed velocity of the masses whose rest position is inside a box; an empty component is free. m/s, of (m, s).
struct Support {
    std::string name;
    std::array<Vec3, 2> box;
    std::array<std::function<double(Vec3, double)>, 3> velocity;

    [[nodiscard]] bool holds(Vec3 rest_position) const;
};

/// Which duplets tie the masses that meet at a vertex.
enum class Duplets : std::uint8_t {
    corners,  ///< one at each corner of each shared face
    tree  ///< of these the fewest that hold the masses together: a tree of each union, breadth first by ascending id
};

/// A duplet and the mass at its other end.
struct Tie {
    LocalDuplet duplet;
    LocalMass mass;
};

/// The problem on this rank, unchanged during a run: entities, duplets and their thresholds, starting unions, supports.
/// Starting unions are the masses that meet at a vertex, with either kind of duplets.
class Network {
public:
    static constexpr int duplets_per_face = Hexahedron::face_corners;

    /// entities: local ones, ascending; owned: 1 where this rank is the owner. Errors found in thresholds are kept for
    /// the caller to agree on with the other ranks: see invalid_threshold().
    Network(const Block& block, const EntityModel& model, IdArray<LocalEntity, EntityId> entities,
            IdArray<LocalEntity, std::uint8_t> owned, Duplets duplets, const Thresholds& thresholds,
            std::vector<Support> supports);

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

    [[nodiscard]] const std::vector<InteriorFace>& interior_faces() const { return interior_faces_; }
    /// Index of the interior face on a face of an entity; -1 on the block's boundary or where the neighbour is not local.
    [[nodiscard]] std::int32_t interior_face_at(LocalEntity e, int face) const {
        return interior_face_of_face_[e.index() * Hexahedron::faces + static_cast<std::size_t>(face)];
    }
    /// The duplet that would tie a mass over a face of its entity; none where there is no interior face or the mass is not on the face.
    [[nodiscard]] std::optional<LocalDuplet> duplet_over(LocalMass m, int face) const {
        const LocalEntity e = entity_of(m);
        const std::int32_t index = interior_face_at(e, face);
        if (index < 0) {
            return std::nullopt;
        }
        const InteriorFace& shared = interior_faces_[static_cast<std::size_t>(index)];
        const int k = shared.a == e ? shared.duplet_at_a(corner_of(m)) : shared.duplet_at_b(corner_of(m));
        return k < 0 ? std::nullopt : std::optional{LocalDuplet{index * duplets_per_face + k}};
    }
    /// The mass that meets this one over a face, and the duplet that would tie them; none where there is no interior face or
    /// the mass is not on the face.
    [[nodiscard]] std::optional<Tie> tie_over(LocalMass m, int face) const;
    /// Threshold, a stretch, of a duplet that ties masses of a touched union.
    [[nodiscard]] double threshold(LocalDuplet d) const {
        CRACKSIM_EXPECT(has_touched_duplet(d.value() / duplets_per_face, d.value() % duplets_per_face));
        return threshold_.empty() ? uniform_threshold_ : threshold_[d.index()];
    }
    /// Bit k is set where duplet k of an interior face exists and ties masses of a touched union.
    [[nodiscard]] std::uint8_t touched_duplets(std::int32_t interior_face) const {
        return touched_duplets_[static_cast<std::size_t>(interior_face)];
    }
    [[nodiscard]] bool has_touched_duplet(std::int32_t interior_face, int k) const {
        return ((static_cast<unsigned>(touched_duplets(interior_face)) >> static_cast<unsigned>(k)) & 1U) != 0;
    }

    [[nodiscard]] const Lattice& lattice() const { return *lattice_; }
    /// The same; it does not move with the network.
    [[nodiscard]] const std::shared_ptr<const Lattice>& shared_lattice() const { return lattice_; }
    /// Calls action(masses) with the masses, ascending, of each touched union at the start: those of a mass that this rank owns. All
    /// their masses are local.
    template <class Action>
    void for_each_union(Action&& action) const {
        for_each_vertex([&](std::span<const LocalMass> masses, bool touched) {
            if (touched) {
                action(masses);
            }
        });
    }
    /// Local masses of unions that are not touched, ascending: their motion comes from the owners of their entities.
    [[nodiscard]] const std::vector<LocalMass>& received() const { return received_; }
    [[nodiscard]] const std::vector<Support>& supports() const { return supports_; }

    /// What is wrong with a threshold of this rank (not a number, or not above zero), if any.
    [[nodiscard]] const std::optional<std::string>& invalid_threshold() const { return invalid_threshold_; }

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void find_received();
    /// Calls action(masses, touched) with the local masses at each vertex that has some, ascending.
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
    void find_interior_faces();
    void find_duplets(Duplets duplets);
    void add_duplet(LocalDuplet duplet);
    void add_tree(std::span<const LocalMass> masses);
    void set_thresholds(const Thresholds& thresholds);
    void set_threshold(LocalDuplet duplet, double threshold, bool is_first);

    Block block_;
    EntityModel model_;
    IdArray<LocalEntity, EntityId> entities_;
    IdArray<LocalEntity, std::uint8_t> owned_;
    std::shared_ptr<const Lattice> lattice_;
    std::vector<Support> supports_;
    std::vector<InteriorFace> interior_faces_;
    std::vector<std::int32_t> interior_face_of_face_;
    std::vector<double> threshold_;  ///< by duplet; empty: all are uniform_threshold_
    double uniform_threshold_{0};
    std::vector<std::uint8_t> touched_duplets_;
    std::vector<LocalMass> received_;
    std::optional<std::string> invalid_threshold_;
};

}  // namespace cracksim::physics
