#include "surface/coat.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/text.hpp"
#include "geometry/boundary.hpp"
#include "topology/construct.hpp"
#include "topology/modify.hpp"
#include "topology/validity.hpp"

namespace cracksim::surface {

namespace {

/// The links of components: sewn faces with an owned entity on at least one side. Faces between two halo entities are
/// left out, because their owners have them.
class SewnFaces {
public:
    SewnFaces(const topology::GMap& map, const partition::Decomposition& decomposition)
        : map_{map}, owned_{decomposition.owned} {}

    void for_each_neighbour(LocalEntity e, const auto& visit) const {
        for (int face = 0; face < topology::Cell::faces; ++face) {
            if (map_.leads_on(e, face) && is_known(e, map_.link(e, face).entity())) {
                visit(map_.link(e, face).entity());
            }
        }
    }
    [[nodiscard]] bool joins(LocalEntity a, LocalEntity b) const {
        bool found = false;
        for_each_neighbour(a, [&](LocalEntity other) { found = found || other == b; });
        return found;
    }
    [[nodiscard]] bool is_known(LocalEntity a, LocalEntity b) const { return owned_[a] != 0 || owned_[b] != 0; }

private:
    const topology::GMap& map_;
    const IdArray<LocalEntity, std::uint8_t>& owned_;
};

/// A message from the owner of an entity to the ranks that hold it as halo.
struct Mask {
    EntityId entity;
    std::uint8_t sewn;
};

void append_corners(LocalEntity e, unsigned faces, std::vector<LocalMass>& corners) {
    for (int face = 0; face < topology::Cell::faces; ++face) {
        if ((faces >> static_cast<unsigned>(face) & 1U) != 0) {
            for (const LocalMass corner : topology::corners_of(e, face)) {
                corners.push_back(corner);
            }
        }
    }
}

/// The map of this rank's entities as far as their unions hold them together. Of faces between halo entities their
/// owners know. Collective.
topology::GMap map_of(const Block& block, const partition::Decomposition& decomposition, const partition::Halo& halo,
                      const physics::Unions& unions) {
    topology::GMap map = topology::construct(block, decomposition.entities.span());
    topology::unsew_parted(map, [&](LocalMass a, LocalMass b) { return unions.part(a) == unions.part(b); });
    std::vector<std::uint8_t> masks;
    masks.reserve(decomposition.entities.size());
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        masks.push_back(map.sewn_mask(e));
    }
    halo.update<std::uint8_t>(masks);
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        map.set_sewn_mask(e, masks[e.index()]);
    }
    return map;
}

geometry::SharedUnions shared_unions(const partition::Decomposition& decomposition, const physics::Unions& unions) {
    geometry::SharedUnions shared{decomposition.entities.size() * Hexahedron::corners};
    std::vector<LocalMass> masses;
    unions.for_each_advanced_union([&](physics::LocalUnion s) {
        unions.masses(s, masses);
        shared.set(masses);
    });
    return shared;
}

/// By entity, a bit for each face that is notched; empty without notches.
IdArray<LocalEntity, std::uint8_t> notched_faces(const physics::Network& network) {
    if (network.notched_faces().empty()) {
        return {};
    }
    IdArray<LocalEntity, std::uint8_t> found(network.entities().size());
    const auto add = [&](LocalEntity e, unsigned face) { found[e] = static_cast<std::uint8_t>(found[e] | 1U << face); };
    for (const std::int32_t f : network.notched_faces()) {
        const physics::InteriorFace& face = network.interior_faces()[f];
        add(face.a, face.face_a);
        add(face.b, face.face_b);
    }
    return found;
}

}  // namespace

Coat::Coat(const partition::Communicator& comm, const physics::Network& network,
           const partition::Decomposition& decomposition, const physics::Unions& unions)
    : comm_{&comm},
      decomposition_{&decomposition},
      block_{network.block()},
      halo_{comm, decomposition},
      map_{map_of(block_, decomposition, halo_, unions)},
      unions_{shared_unions(decomposition, unions)},
      search_{decomposition.entities.size()},
      components_{comm, decomposition, halo_, SewnFaces{map_, decomposition}},
      fragments_{comm, decomposition, halo_, unions_},
      surface_{map_, decomposition.owned.span(), [](LocalEntity, int) { return 0.0; }},
      notched_{notched_faces(network)} {}

void Coat::modify(const physics::SplitStream& splits) {
    if (comm_->sum(static_cast<std::int64_t>(splits.size())) == 0) {
        return;
    }
    const topology::Changes changes = topology::modify(map_, splits);
    count_opened(changes);
    update_surface(changes, share_masks(changes));
    std::array<std::int64_t, 2> parted{cut_components(changes) ? 1 : 0, cut_fragments(splits) ? 1 : 0};
    comm_->sum(parted);
    if (parted[0] != 0) {
        components_.agree();
    }
    if (parted[1] != 0) {
        fragments_.agree();
        ++fragments_version_;
    }
}

void Coat::count_opened(const topology::Changes& changes) {
    std::array<std::int64_t, 3> opened{};
    for (const topology::UnsewnFace& face : changes.unsewn) {
        const bool counts = decomposition_->owned[face.entity] != 0 && !is_notched(face.entity, face.face);
        opened[static_cast<std::size_t>(face.face / 2)] += counts ? 1 : 0;
    }
    comm_->sum(opened);
    for (std::size_t axis = 0; axis < opened.size(); ++axis) {
        opened_[axis] += opened[axis];
    }
}

std::vector<LocalMass> Coat::share_masks(const topology::Changes& changes) {
    std::vector<std::vector<Mask>> outgoing(static_cast<std::size_t>(comm_->size()));
    const auto send = [&](LocalEntity e) {
        for (const Rank holder : decomposition_->owned[e] != 0 ? halo_.holders(e) : std::span<const Rank>{}) {
            outgoing[holder.index()].push_back({decomposition_->entities[e], map_.sewn_mask(e)});
        }
    };
    for (const topology::UnsewnFace& face : changes.unsewn) {
        send(face.entity);
        send(face.neighbour);
    }
    std::vector<LocalMass> corners;
    for (const auto& masks : comm_->exchange(outgoing)) {
        for (const Mask& mask : masks) {
            const LocalEntity e = *find_local(decomposition_->entities, mask.entity);
            const unsigned freed = map_.sewn_mask(e) & ~unsigned{mask.sewn};
            map_.set_sewn_mask(e, mask.sewn);
            append_corners(e, freed, corners);
        }
    }
    return corners;
}

void Coat::update_surface(const topology::Changes& changes, std::vector<LocalMass> corners) {
    for (const topology::UnsewnFace& face : changes.unsewn) {
        const double time = is_notched(face.entity, face.face) ? 0.0 : face.time;
        surface_.open(face.entity, face.face, time);
        surface_.open(face.neighbour, face.neighbour_face, time);
        append_corners(face.entity, 1U << static_cast<unsigned>(face.face), corners);
        append_corners(face.neighbour, 1U << static_cast<unsigned>(face.neighbour_face), corners);
    }
    surface_.update(map_, corners);
}

bool Coat::cut_components(const topology::Changes& changes) {
    const SewnFaces links{map_, *decomposition_};
    std::vector<LocalEntity> at;
    for (const topology::UnsewnFace& face : changes.unsewn) {
        if (links.is_known(face.entity, face.neighbour)) {
            at.insert(at.end(), {face.entity, face.neighbour});
        }
    }
    return components_.cut(at, search_, links);
}

bool Coat::cut_fragments(const physics::SplitStream& splits) {
    std::vector<LocalEntity> at;
    for (std::size_t s = 0; s < splits.size(); ++s) {
        for (std::size_t part = 0; part < splits.parts(s); ++part) {
            unions_.set(splits.part(s, part));
            for (const LocalMass mass : splits.part(s, part)) {
                at.push_back(entity_of(mass));
            }
        }
    }
    return fragments_.cut(at, search_, unions_);
}

double Coat::crack_area() const {
    double area = 0;
    for (int axis = 0; axis < 3; ++axis) {
        area += static_cast<double>(opened_[static_cast<std::size_t>(axis)]) * block_.face_area(2 * axis);
    }
    return area;
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
    all.reserve(entities.size());
    for (const auto& [label, number] : entities) {
        all.push_back({label, number, static_cast<double>(number) * entity_volume});
    }
    std::ranges::stable_sort(all, [](const auto& a, const auto& b) { return a.entities > b.entities; });
    all.resize(std::min(all.size(), count));
    return all;
}

std::optional<std::string> Coat::find_fault(const physics::Unions& unions, const physics::Evolution& evolution) const {
    const auto shares_union = [&](LocalMass a, LocalMass b) { return unions.part(a) == unions.part(b); };
    const auto is_owned = [&](LocalEntity e, int) { return decomposition_->owned[e] != 0; };
    IdArray<LocalEntity, EntityId> component(decomposition_->entities.size());
    for (LocalEntity e{0}; e.index() < component.size(); ++e) {
        component[e] = decomposition_->owned[e] != 0 ? components_.id(e) : EntityId{};
    }
    halo_.update(component.span());
    const auto faces = geometry::free_faces(map_, decomposition_->owned.span());
    std::optional<std::string> fault = topology::validate(map_);
    fault = fault ? fault : topology::validate_sewing(map_, is_owned, shares_union);
    fault = fault ? fault : geometry::validate_closure(map_, faces, component);
    fault = comm_->first(fault);
    return fault ? fault : find_open_boundary(faces, component, evolution);
}

std::optional<std::string> Coat::find_open_boundary(std::span<const geometry::FreeFace> faces,
                                                    const IdArray<LocalEntity, EntityId>& component,
                                                    const physics::Evolution& evolution) const {
    constexpr double rounding = 1e-9;
    std::map<EntityId, geometry::BoundaryMeasure> all;
    const auto here = geometry::measure_boundaries(faces, component, evolution, block_.origin());
    for (const geometry::BoundaryMeasure& part : comm_->gather_on_all<geometry::BoundaryMeasure>(here)) {
        all.try_emplace(part.label, geometry::BoundaryMeasure{part.label, {}, 0, 0}).first->second += part;
    }
    for (const auto& [id, boundary] : all) {
        if (!(boundary.open_part() < rounding)) {
            return "the boundary of component " + std::to_string(id.value()) +
                   " is not closed: its area vectors add up to " + rounded(boundary.open_part(), 3) + " of its area";
        }
    }
    return std::nullopt;
}

std::size_t Coat::memory_bytes() const {
    return map_.memory_bytes() + unions_.memory_bytes() + search_.memory_bytes() + notched_.bytes() +
           components_.memory_bytes() + fragments_.memory_bytes() + surface_.memory_bytes();
}

}  // namespace cracksim::surface
