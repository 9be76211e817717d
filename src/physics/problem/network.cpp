#include "physics/problem/network.hpp"

#include <algorithm>
#include <cmath>

#include "core/contracts.hpp"
#include "core/text.hpp"

namespace cracksim::physics {

Network::Network(NetworkParts parts)
    : block_{parts.block},
      model_{parts.model},
      entities_{std::move(parts.entities)},
      owned_{std::move(parts.owned)},
      lattice_{std::make_shared<const Lattice>(block_, entities_)},
      supports_{std::move(parts.supports)},
      interior_faces_{block_, entities_},
      duplets_{interior_faces_.size()},
      sensors_{parts.sensors} {
    CRACKSIM_EXPECT(std::ranges::is_sorted(entities_.span()) && owned_.size() == entities_.size());
    find_received();
    find_notched_faces(parts.notches);
    find_duplets(parts.duplets);
    if (sensors_ == SensorKind::stress) {
        set_face_thresholds(parts.thresholds);
    } else {
        set_thresholds(parts.thresholds);
    }
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

void Network::find_notched_faces(const std::vector<Notch>& notches) {
    faces_of_notches_.assign(notches.size(), 0);
    for (std::int32_t f = 0; !notches.empty() && f < static_cast<std::int32_t>(interior_faces_.size()); ++f) {
        const InteriorFace& face = interior_faces_[f];
        const Vec3 from = block_.centre(entities_[face.a]);
        const Vec3 to = block_.centre(entities_[face.b]);
        bool is_crossed = false;
        for (std::size_t n = 0; n < notches.size(); ++n) {
            const bool crosses = notches[n].surface.crosses(from, to);
            faces_of_notches_[n] += crosses && owned(face.a) ? 1 : 0;
            is_crossed = is_crossed || crosses;
        }
        if (is_crossed) {
            notched_faces_.push_back(f);
        }
    }
}

bool Network::is_notched(std::int32_t interior_face) const {
    return std::ranges::binary_search(notched_faces_, interior_face);
}

std::optional<Tie> Network::tie_over(LocalMass m, int face) const {
    const auto duplet = duplet_over(m, face);
    if (!duplet) {
        return std::nullopt;
    }
    const auto [a, b] = masses_of(*duplet);
    return Tie{*duplet, a == m ? b : a};
}

void Network::find_duplets(DupletKind kind) {
    std::vector<LocalMass> reached;
    for_each_touched_vertex([&](std::span<const LocalMass> masses) {
        if (kind == DupletKind::corners) {
            add_ties(masses);
            return;
        }
        reached.clear();
        for (const LocalMass m : masses) {
            if (std::ranges::find(reached, m) == reached.end()) {
                add_tree(m, reached);
            }
        }
    });
}

void Network::add_ties(std::span<const LocalMass> masses) {
    for (const LocalMass m : masses) {
        for (int face = 0; face < Hexahedron::faces; ++face) {
            const auto duplet = duplet_over(m, face);
            if (duplet && !is_notched(interior_face_of(*duplet))) {
                duplets_.insert(*duplet);
            }
        }
    }
}

void Network::add_tree(LocalMass root, std::vector<LocalMass>& reached) {
    std::size_t next = reached.size();
    reached.push_back(root);
    for (; next < reached.size(); ++next) {
        std::vector<Tie> ties;
        for (int face = 0; face < Hexahedron::faces; ++face) {
            const auto tie = tie_over(reached[next], face);
            if (tie && !is_notched(interior_face_of(tie->duplet)) &&
                std::ranges::find(reached, tie->mass) == reached.end()) {
                ties.push_back(*tie);
            }
        }
        std::ranges::sort(ties, {}, &Tie::mass);
        for (const Tie& tie : ties) {
            duplets_.insert(tie.duplet);
            reached.push_back(tie.mass);
        }
    }
}

void Network::set_thresholds(const Thresholds& thresholds) {
    bool is_first = true;
    duplets_.for_each([&](LocalDuplet d) {
        const auto [a, b] = masses_of(d);
        const Vec3 at = rest_position(a);
        const double value = thresholds.of(mass(a), mass(b), at);
        set_threshold(d.index(), interior_faces_.size() * duplets_per_face, value, at, is_first);
        is_first = false;
    });
}

void Network::set_face_thresholds(const Thresholds& thresholds) {
    bool is_first = true;
    for (std::int32_t f = 0; f < static_cast<std::int32_t>(interior_faces_.size()); ++f) {
        if (duplets_.of_face(f) != 0) {
            const InteriorFace& face = interior_faces_[f];
            const Vec3 at = centre(face);
            const double value = thresholds.of(entities_[face.a], entities_[face.b], at);
            set_threshold(static_cast<std::size_t>(f), interior_faces_.size(), value, at, is_first);
            is_first = false;
        }
    }
}

Vec3 Network::centre(const InteriorFace& face) const {
    const Vec3 lower = rest_position(local_mass(face.a, face.corner_a(0)));
    const Vec3 upper = rest_position(local_mass(face.a, face.corner_a(2)));
    return 0.5 * (lower + upper);
}

/// The calls must be in ascending order of sensors. Most blocks have one threshold, so the list of thresholds is made
/// only when a second value occurs.
void Network::set_threshold(std::size_t sensor, std::size_t sensors, double threshold, Vec3 at, bool is_first) {
    if (is_first) {
        uniform_threshold_ = threshold;
    } else if (threshold_.empty() && threshold != uniform_threshold_) {
        threshold_.assign(sensors, uniform_threshold_);
    }
    if (!threshold_.empty()) {
        threshold_[sensor] = threshold;
    }
    lowest_threshold_ = std::min(lowest_threshold_, threshold);
    if (!(threshold > 0) && !invalid_threshold_) {
        invalid_threshold_ = "the threshold at x = " + rounded(at.x, 6) + ", y = " + rounded(at.y, 6) +
                             ", z = " + rounded(at.z, 6) + " m is " +
                             (std::isnan(threshold) ? "not a number" : rounded(threshold, 6));
    }
}

std::size_t Network::memory_bytes() const {
    return entities_.bytes() + owned_.bytes() + interior_faces_.memory_bytes() +
           notched_faces_.capacity() * sizeof(std::int32_t) + threshold_.capacity() * sizeof(double) +
           duplets_.memory_bytes() + lattice_->memory_bytes() + received_.capacity() * sizeof(LocalMass);
}

}  // namespace cracksim::physics
