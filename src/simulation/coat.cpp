#include "simulation/coat.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

#include "geometry/fragments.hpp"
#include "topology/components.hpp"
#include "topology/construct.hpp"
#include "topology/modify.hpp"

namespace cracksim::simulation {

namespace {

std::int64_t face_key(LocalEntity e, int face) { return std::int64_t{e.value()} * Hexahedron::faces + face; }

IdArray<LocalEntity, EntityId> components_here(const topology::GMap& map, const partition::Decomposition& d) {
    IdArray<LocalEntity, EntityId> labels = d.entities;
    topology::lower_to_component(map, d.owned.span(), labels);
    return labels;
}

IdArray<LocalEntity, EntityId> fragments_here(const geometry::SharedUnions& unions, const partition::Decomposition& d) {
    IdArray<LocalEntity, EntityId> labels = d.entities;
    geometry::lower_to_fragment(unions.pairs(), labels);
    return labels;
}

/// What the owner of an entity tells those who hold it as halo.
struct Mask {
    EntityId entity;
    std::uint8_t sewn;
};

}  // namespace

Coat::Coat(const partition::Communicator& comm, const Block& block, const partition::Decomposition& decomposition,
           geometry::SharedUnions unions)
    : comm_{&comm},
      decomposition_{&decomposition},
      block_{block},
      halo_{comm, decomposition},
      map_{topology::construct(block, decomposition.entities.span())},
      unions_{std::move(unions)},
      search_{decomposition.entities.size()},
      components_{comm, decomposition, halo_, components_here(map_, decomposition)},
      fragments_{comm, decomposition, halo_, fragments_here(unions_, decomposition)} {}

void Coat::modify(const physics::SplitStream& splits) {
    if (comm_->sum(static_cast<std::int64_t>(splits.size())) == 0) {
        return;
    }
    const topology::Changes changes = topology::modify(map_, splits);
    note_opened(changes);
    share_masks(changes);
    std::array<std::int64_t, 2> parted{cut_components(changes) ? 1 : 0, cut_fragments(splits) ? 1 : 0};
    comm_->sum(parted);
    if (parted[0] != 0) {
        components_.agree();
    }
    if (parted[1] != 0) {
        fragments_.agree();
    }
}

void Coat::note_opened(const topology::Changes& changes) {
    std::array<std::int64_t, 3> opened{};
    for (const topology::UnsewnFace& face : changes.unsewn) {
        opened_at_.emplace(face_key(face.entity, face.face), face.time);
        opened_at_.emplace(face_key(face.neighbour, face.neighbour_face), face.time);
        opened[static_cast<std::size_t>(face.face / 2)] += decomposition_->owned[face.entity] != 0 ? 1 : 0;
    }
    comm_->sum(opened);
    for (std::size_t axis = 0; axis < opened.size(); ++axis) {
        opened_[axis] += opened[axis];
    }
}

void Coat::share_masks(const topology::Changes& changes) {
    std::vector<std::vector<Mask>> outgoing(static_cast<std::size_t>(comm_->size()));
    const auto tell = [&](LocalEntity e) {
        for (const Rank holder : decomposition_->owned[e] != 0 ? halo_.holders(e) : std::span<const Rank>{}) {
            outgoing[holder.index()].push_back({decomposition_->entities[e], map_.sewn_mask(e)});
        }
    };
    for (const topology::UnsewnFace& face : changes.unsewn) {
        tell(face.entity);
        tell(face.neighbour);
    }
    for (const auto& masks : comm_->exchange(outgoing)) {
        for (const Mask& mask : masks) {
            map_.set_sewn_mask(*find_local(decomposition_->entities, mask.entity), mask.sewn);
        }
    }
}

// A face between two halo entities is no link here: their owners know of it.
bool Coat::cut_components(const topology::Changes& changes) {
    const auto owned = [&](LocalEntity e) { return decomposition_->owned[e] != 0; };
    std::vector<LocalEntity> at;
    for (const topology::UnsewnFace& face : changes.unsewn) {
        if (owned(face.entity) || owned(face.neighbour)) {
            at.insert(at.end(), {face.entity, face.neighbour});
        }
    }
    return components_.cut(std::move(at), search_, [&](LocalEntity e, const auto& visit) {
        for (int face = 0; face < topology::Cell::faces; ++face) {
            if (map_.leads_on(e, face) && (owned(e) || owned(map_.link(e, face).entity()))) {
                visit(map_.link(e, face).entity());
            }
        }
    });
}

bool Coat::cut_fragments(const physics::SplitStream& splits) {
    std::vector<LocalEntity> at;
    for (std::size_t s = 0; s < splits.size(); ++s) {
        for (std::size_t part = 0; part < splits.parts(s); ++part) {
            unions_.set(splits.part(s, part));
            at.push_back(entity_of(splits.part(s, part).front()));
        }
    }
    return fragments_.cut(std::move(at), search_, [&](LocalEntity e, const auto& visit) {
        unions_.for_each_neighbour(e, visit);
    });
}

double Coat::crack_area() const {
    double area = 0;
    for (int axis = 0; axis < 3; ++axis) {
        area += static_cast<double>(opened_[static_cast<std::size_t>(axis)]) * block_.face_area(2 * axis);
    }
    return area;
}

double Coat::opened_at(LocalEntity e, int face) const {
    const auto found = opened_at_.find(face_key(e, face));
    return found == opened_at_.end() ? -1.0 : found->second;
}

std::vector<geometry::LabelSize> Coat::largest_fragments(std::size_t count) const {
    IdArray<LocalEntity, EntityId> labels(decomposition_->entities.size());
    for (LocalEntity e{0}; e.index() < labels.size(); ++e) {
        labels[e] = decomposition_->owned[e] != 0 ? fragment(e) : EntityId{};
    }
    const double entity_volume = block_.volume() / static_cast<double>(block_.entity_count());
    const auto here = geometry::label_sizes(labels, decomposition_->owned.span(), entity_volume);
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

std::size_t Coat::memory_bytes() const {
    return map_.memory_bytes() + unions_.memory_bytes() + search_.memory_bytes() + components_.memory_bytes() +
           fragments_.memory_bytes();
}

}  // namespace cracksim::simulation
