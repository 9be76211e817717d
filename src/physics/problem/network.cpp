#include "physics/problem/network.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/contracts.hpp"
#include "core/text.hpp"

namespace cracksim::physics {

bool Support::holds(Vec3 p) const {
    return p.x >= box[0].x && p.x <= box[1].x && p.y >= box[0].y && p.y <= box[1].y && p.z >= box[0].z &&
           p.z <= box[1].z;
}

Network::Network(const Block& block, const EntityModel& model, IdArray<LocalEntity, EntityId> entities,
                 IdArray<LocalEntity, std::uint8_t> owned, Duplets duplets, const Thresholds& thresholds,
                 std::vector<Support> supports)
    : block_{block},
      model_{model},
      entities_{std::move(entities)},
      owned_{std::move(owned)},
      lattice_{std::make_shared<const Lattice>(block, entities_)},
      supports_{std::move(supports)} {
    CRACKSIM_EXPECT(std::ranges::is_sorted(entities_.span()) && owned_.size() == entities_.size());
    find_received();
    find_interior_faces();
    find_duplets(duplets);
    set_thresholds(thresholds);
}

void Network::find_received() {
    for_each_vertex([&](std::span<const LocalMass> masses, bool touched) {
        if (!touched) {
            received_.insert(received_.end(), masses.begin(), masses.end());
        }
    });
    std::ranges::sort(received_);
    received_.shrink_to_fit();
}

void Network::find_interior_faces() {
    interior_face_of_face_.assign(entities_.size() * Hexahedron::faces, -1);
    for (LocalEntity a{0}; a.value() < entity_count(); ++a) {
        for (int face = 0; face < Hexahedron::faces; ++face) {
            const auto other = block_.neighbour(entities_[a], face);
            if (!other || other->entity < entities_[a]) {
                continue;
            }
            const auto found = find_local(entities_, other->entity);
            if (!found) {
                continue;
            }
            const LocalEntity b = *found;
            const auto index = static_cast<std::int32_t>(interior_faces_.size());
            interior_face_of_face_[a.index() * Hexahedron::faces + static_cast<std::size_t>(face)] = index;
            interior_face_of_face_[b.index() * Hexahedron::faces + static_cast<std::size_t>(other->face)] = index;
            interior_faces_.push_back({a, b, static_cast<std::uint8_t>(face), static_cast<std::uint8_t>(other->face),
                                   static_cast<std::uint8_t>(other->rotation)});
        }
    }
    interior_faces_.shrink_to_fit();
}

std::optional<Tie> Network::tie_over(LocalMass m, int face) const {
    const auto duplet = duplet_over(m, face);
    if (!duplet) {
        return std::nullopt;
    }
    const InteriorFace& shared = interior_faces_[duplet->index() / duplets_per_face];
    const int k = duplet->value() % duplets_per_face;
    return Tie{*duplet, shared.a == entity_of(m) ? local_mass(shared.b, shared.corner_b(k))
                                                 : local_mass(shared.a, shared.corner_a(k))};
}

void Network::find_duplets(Duplets duplets) {
    touched_duplets_.assign(interior_faces_.size(), 0);
    for_each_union([&](std::span<const LocalMass> masses) {
        if (duplets == Duplets::tree) {
            add_tree(masses);
            return;
        }
        for (const LocalMass m : masses) {
            for (int face = 0; face < Hexahedron::faces; ++face) {
                if (const auto tie = tie_over(m, face)) {
                    add_duplet(tie->duplet);
                }
            }
        }
    });
}

void Network::add_duplet(LocalDuplet duplet) {
    auto& places = touched_duplets_[duplet.index() / duplets_per_face];
    places = static_cast<std::uint8_t>(places | (1U << duplet.index() % duplets_per_face));
}

void Network::add_tree(std::span<const LocalMass> masses) {
    std::vector<LocalMass> reached{masses.front()};
    for (std::size_t next = 0; next < reached.size(); ++next) {
        std::vector<Tie> ties;
        for (int face = 0; face < Hexahedron::faces; ++face) {
            const auto tie = tie_over(reached[next], face);
            if (tie && std::ranges::find(reached, tie->mass) == reached.end()) {
                ties.push_back(*tie);
            }
        }
        std::ranges::sort(ties, {}, &Tie::mass);
        for (const Tie& tie : ties) {
            add_duplet(tie.duplet);
            reached.push_back(tie.mass);
        }
    }
}

void Network::set_thresholds(const Thresholds& thresholds) {
    bool is_first = true;
    for (std::size_t i = 0; i < interior_faces_.size(); ++i) {
        for (int k = 0; k < duplets_per_face; ++k) {
            if (!has_touched_duplet(static_cast<std::int32_t>(i), k)) {
                continue;
            }
            const LocalMass a = local_mass(interior_faces_[i].a, interior_faces_[i].corner_a(k));
            const LocalMass b = local_mass(interior_faces_[i].b, interior_faces_[i].corner_b(k));
            const Vec3 at = rest_position(a);
            const double value = thresholds.of(mass(a), mass(b), at);
            set_threshold(LocalDuplet{static_cast<std::int32_t>(i) * duplets_per_face + k}, value, is_first);
            is_first = false;
            if (!(value > 0) && !invalid_threshold_) {
                invalid_threshold_ = "the threshold at x = " + rounded(at.x, 6) + ", y = " + rounded(at.y, 6) +
                                     ", z = " + rounded(at.z, 6) + " m is " +
                                     (std::isnan(value) ? "not a number" : rounded(value, 6));
            }
        }
    }
}

/// In ascending order. Most blocks have one threshold: a list is made when there is a second one.
void Network::set_threshold(LocalDuplet duplet, double threshold, bool is_first) {
    if (is_first) {
        uniform_threshold_ = threshold;
    } else if (threshold_.empty() && threshold != uniform_threshold_) {
        threshold_.assign(interior_faces_.size() * duplets_per_face, uniform_threshold_);
    }
    if (!threshold_.empty()) {
        threshold_[duplet.index()] = threshold;
    }
}

std::size_t Network::memory_bytes() const {
    return entities_.bytes() + owned_.bytes() + interior_faces_.capacity() * sizeof(InteriorFace) +
           interior_face_of_face_.capacity() * sizeof(std::int32_t) + threshold_.capacity() * sizeof(double) +
           touched_duplets_.capacity() + lattice_->memory_bytes() + received_.capacity() * sizeof(LocalMass);
}

}  // namespace cracksim::physics
