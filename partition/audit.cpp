#include "partition/audit.hpp"

#include <algorithm>

namespace cracksim::partition {

namespace {

using EntityView = std::array<MassView, Hexahedron::corners>;

std::string name(MassId mass) { return "mass " + std::to_string(mass.value()); }

std::optional<std::string> difference(EntityId entity, const EntityView& owner, const EntityView& here) {
    for (int corner = 0; corner < Hexahedron::corners; ++corner) {
        const auto c = static_cast<std::size_t>(corner);
        if (owner[c].motion_hash != here[c].motion_hash) {
            return name(mass_id(entity, corner)) + " moves differently here and at its owner";
        }
        const bool both_know = owner[c].mass_union >= 0 && here[c].mass_union >= 0;
        if (both_know && owner[c].mass_union != here[c].mass_union) {
            return name(mass_id(entity, corner)) + " is in another union here than at its owner";
        }
    }
    return std::nullopt;
}

std::optional<std::string> with_rank(const Communicator& comm, std::optional<std::string> finding) {
    if (finding) {
        *finding += " (rank " + std::to_string(comm.rank().value()) + ")";
    }
    return comm.first(finding);
}

}  // namespace

Audit::Audit(const Communicator& comm, const Decomposition& decomposition)
    : comm_{&comm}, decomposition_{&decomposition}, halo_{comm, decomposition} {}

std::optional<std::string> Audit::check_plan(const ExchangePlan& plan) const {
    std::vector<std::int64_t> echoed(plan.received().size());
    plan.exchange<std::int64_t>(plan.sent(), echoed);
    std::optional<std::string> finding;
    for (std::size_t i = 0; i < echoed.size() && !finding; ++i) {
        if (echoed[i] != plan.received()[i]) {
            finding = name(MassId{plan.received()[i]}) + " is delivered as " + name(MassId{echoed[i]});
        }
    }
    const auto twice = std::adjacent_find(plan.received().begin(), plan.received().end());
    if (!finding && twice != plan.received().end()) {
        finding = name(MassId{*twice}) + " is received twice";
    }
    return with_rank(*comm_, finding);
}

std::optional<std::string> Audit::check_masses(const std::function<MassView(LocalMass)>& view) const {
    std::vector<EntityView> views(decomposition_->entities.size());
    for (LocalEntity e{0}; e.index() < views.size(); ++e) {
        for (int corner = 0; corner < Hexahedron::corners; ++corner) {
            views[e.index()][static_cast<std::size_t>(corner)] = view(local_mass(e, corner));
        }
    }
    std::vector<EntityView> owners = views;
    halo_.update<EntityView>(owners);
    std::optional<std::string> finding;
    for (LocalEntity e{0}; e.index() < views.size() && !finding; ++e) {
        finding = difference(decomposition_->entities[e], owners[e.index()], views[e.index()]);
    }
    return with_rank(*comm_, finding);
}

std::optional<std::string> Audit::check_contributions(const Block& block, std::span<const std::int32_t> reads) const {
    const auto& [entities, owner, owned] = *decomposition_;
    std::vector<std::int32_t> owed(reads.size(), 0);
    std::optional<std::string> finding;
    for (LocalEntity e{0}; e.index() < entities.size(); ++e) {
        for (int corner = 0; corner < Hexahedron::corners; ++corner) {
            bool touched = false;
            bool whole = true;
            for (const EntityId other : block.around(block.vertex(entities[e], corner))) {
                const auto local = find_local(entities, other);
                whole = whole && local;
                touched = touched || (local && owned[*local] != 0);
            }
            owed[local_mass(e, corner).index()] = touched ? 1 : 0;
            if (touched && !whole && !finding) {
                finding = "the union of " + name(mass_id(entities[e], corner)) + " is advanced without all its masses";
            }
        }
    }
    for (LocalMass m{0}; m.index() < reads.size() && !finding; ++m) {
        if (reads[m.index()] != owed[m.index()]) {
            finding = "the force on " + name(mass_id(entities[entity_of(m)], corner_of(m))) + " is read " +
                      std::to_string(reads[m.index()]) + " times instead of " + std::to_string(owed[m.index()]);
        }
    }
    return with_rank(*comm_, finding);
}

}  // namespace cracksim::partition
