#include "simulation/coat.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <ranges>
#include <span>

#include "geometry/fragments.hpp"
#include "topology/components.hpp"
#include "topology/construct.hpp"
#include "topology/modify.hpp"

namespace cracksim::simulation {

namespace {

std::int64_t face_key(LocalEntity e, int face) { return std::int64_t{e.value()} * Hexahedron::faces + face; }

/// Lowers labels on every rank until no rank changes one. lower(labels) -> did anything change. Collective.
IdArray<LocalEntity, EntityId> agree_on_labels(const partition::Communicator& comm,
                                               const partition::Decomposition& decomposition,
                                               const partition::Halo& halo, auto&& lower) {
    IdArray<LocalEntity, EntityId> labels = decomposition.entities;
    bool changed = true;
    while (comm.any(changed)) {
        changed = lower(labels);
        halo.update(labels.span());
    }
    return labels;
}

std::int64_t count_labels(const partition::Communicator& comm, const partition::Decomposition& decomposition,
                          const IdArray<LocalEntity, EntityId>& labels) {
    std::int64_t count = 0;
    for (LocalEntity e{0}; e.index() < labels.size(); ++e) {
        count += decomposition.owned[e] != 0 && labels[e] == decomposition.entities[e] ? 1 : 0;
    }
    return comm.sum(count);
}

/// The masses of each advanced union, one after the other in the same buffer.
auto advanced_unions(const physics::UnionTable& unions, std::vector<LocalMass>& buffer) {
    return unions.advanced() | std::views::transform([&](physics::Slot s) -> std::span<const LocalMass> {
               unions.masses(s, buffer);
               return buffer;
           });
}

}  // namespace

Coat::Coat(const partition::Communicator& comm, const Block& block, const partition::Decomposition& decomposition)
    : comm_{&comm},
      decomposition_{&decomposition},
      block_{block},
      halo_{comm, decomposition},
      map_{topology::construct(block, decomposition.entities.span())} {}

void Coat::modify(const physics::SplitStream& splits, const physics::UnionTable& unions) {
    const bool labelled = component_count_ > 0;
    if (comm_->sum(static_cast<std::int64_t>(splits.size())) == 0 && labelled) {
        return;
    }
    for (const topology::UnsewnFace& face : topology::modify(map_, splits).unsewn) {
        opened_at_.emplace(face_key(face.entity, face.face), face.time);
        opened_at_.emplace(face_key(face.neighbour, face.neighbour_face), face.time);
    }
    share_masks();
    label_components();
    label_fragments(unions);
    measure_cracks();
}

void Coat::share_masks() {
    std::vector<std::uint8_t> masks(decomposition_->entities.size());
    for (LocalEntity e{0}; e.index() < masks.size(); ++e) {
        masks[e.index()] = map_.sewn_mask(e);
    }
    halo_.update<std::uint8_t>(masks);
    for (const LocalEntity e : halo_.received()) {
        map_.set_sewn_mask(e, masks[e.index()]);
    }
}

void Coat::label_components() {
    components_ = agree_on_labels(*comm_, *decomposition_, halo_, [&](auto& labels) {
        return topology::lower_to_component(map_, decomposition_->owned.span(), labels);
    });
    component_count_ = count_labels(*comm_, *decomposition_, components_);
}

void Coat::label_fragments(const physics::UnionTable& unions) {
    std::vector<LocalMass> buffer;
    const auto all = advanced_unions(unions, buffer);
    fragments_ = agree_on_labels(*comm_, *decomposition_, halo_,
                                 [&](auto& labels) { return geometry::lower_to_fragment(all, labels); });
    fragment_count_ = count_labels(*comm_, *decomposition_, fragments_);
}

void Coat::measure_cracks() {
    std::array<std::int64_t, 3> opened{};
    for (LocalEntity e{0}; e.index() < decomposition_->entities.size(); ++e) {
        for (int face = 0; decomposition_->owned[e] != 0 && face < Hexahedron::faces; ++face) {
            const auto other = block_.neighbour(decomposition_->entities[e], face);
            const bool counted_here = other && decomposition_->entities[e] < other->entity;
            opened[static_cast<std::size_t>(face / 2)] += counted_here && !map_.is_sewn(e, face) ? 1 : 0;
        }
    }
    crack_area_ = 0;
    for (int axis = 0; axis < 3; ++axis) {
        crack_area_ +=
            static_cast<double>(comm_->sum(opened[static_cast<std::size_t>(axis)])) * block_.face_area(2 * axis);
    }
}

double Coat::opened_at(LocalEntity e, int face) const {
    const auto found = opened_at_.find(face_key(e, face));
    return found == opened_at_.end() ? -1.0 : found->second;
}

std::vector<geometry::LabelSize> Coat::largest_fragments(std::size_t count) const {
    const double entity_volume = block_.volume() / static_cast<double>(block_.entity_count());
    const auto here = geometry::label_sizes(fragments_, decomposition_->owned.span(), entity_volume);
    std::map<EntityId, std::int64_t> entities;
    for (const geometry::LabelSize& size : comm_->gather<geometry::LabelSize>(here)) {
        entities[size.label] += size.entities;
    }
    std::vector<geometry::LabelSize> all;
    for (const auto& [label, number] : entities) {
        all.push_back({label, number, static_cast<double>(number) * entity_volume});
    }
    std::ranges::stable_sort(all, [](const auto& a, const auto& b) { return a.entities > b.entities; });
    all.resize(std::min(all.size(), count));
    return all;
}

}  // namespace cracksim::simulation
