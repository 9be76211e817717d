#include "topology/validity.hpp"

#include <utility>

namespace cracksim::topology {
namespace {

/// alpha3 of a dart over a link, as GMap defines it: a dart of the other cell.
template <class AnyCell>
constexpr int over_link(int face_there, int rotation, int dart) {
    return AnyCell::dart(face_there, edge_met(rotation, AnyCell::place(dart), AnyCell::face_corners),
                         1 - AnyCell::end(dart));
}

/// True if alpha3, alpha0 alpha3 and alpha1 alpha3 are involutions at a dart of face `here`, which is linked to face
/// `there`.
template <class AnyCell>
constexpr bool axioms_hold_over(int here, int there, int rotation, int dart) {
    const auto across = [&](int d) { return over_link<AnyCell>(there, rotation, d); };
    const auto back = [&](int d) { return over_link<AnyCell>(here, rotation, d); };
    bool hold = back(across(dart)) == dart;
    for (int i = 0; i < 2; ++i) {
        const int composed = across(AnyCell::alpha(i, dart));
        hold = hold && back(AnyCell::alpha(i, composed)) == dart;
    }
    return hold;
}

template <class AnyCell>
constexpr bool axioms_hold_over_any_link() {
    for (int here = 0; here < AnyCell::faces; ++here) {
        for (int there = 0; there < AnyCell::faces; ++there) {
            for (int n = 0; n < AnyCell::face_corners * 2 * AnyCell::face_corners; ++n) {
                const int dart = AnyCell::dart(here, n / 2 % AnyCell::face_corners, n % 2);
                if (!axioms_hold_over<AnyCell>(here, there, n / 2 / AnyCell::face_corners, dart)) {
                    return false;
                }
            }
        }
    }
    return true;
}

static_assert(axioms_hold<Cell>());
static_assert(axioms_hold_over_any_link<Cell>());

/// True if both sides of a link refer to each other and are both sewn or both free.
bool sides_agree(const GMap& map, LocalEntity entity, int face) {
    const FaceLink to = map.link(entity, face);
    return !to.is_local() || (map.link(to.entity(), to.face()) == FaceLink::local(entity, face, to.rotation()) &&
                              map.is_sewn(to.entity(), to.face()) == map.is_sewn(entity, face));
}

bool all_sides_agree(const GMap& map) {
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; f < Cell::faces; ++f) {
            if (!sides_agree(map, e, f)) {
                return false;
            }
        }
    }
    return true;
}

std::string name(LocalEntity entity, int face) {
    return "face " + std::to_string(face) + " of local entity " + std::to_string(entity.value());
}

std::string name(Dart dart) {
    return "dart " + std::to_string(dart.value()) + " (edge " + std::to_string(Cell::place(in_cell(dart))) + ", end " +
           std::to_string(Cell::end(in_cell(dart))) + " of " + name(entity_of(dart), face_of(dart)) + ")";
}

bool exists(const GMap& map, FaceLink to) {
    return !to.is_local() || (to.entity().value() < map.entity_count() && to.face() < Cell::faces);
}

std::optional<std::string> check_target(const GMap& map, LocalEntity entity, int face) {
    if (exists(map, map.link(entity, face))) {
        return std::nullopt;
    }
    return name(entity, face) + " is linked to an entity or face that does not exist";
}

/// Checks free faces too: both sides must have the same link from construction.
std::optional<std::string> check_return(const GMap& map, LocalEntity entity, int face) {
    const FaceLink to = map.link(entity, face);
    if (!to.is_local() || map.link(to.entity(), to.face()) == FaceLink::local(entity, face, to.rotation())) {
        return std::nullopt;
    }
    return name(entity, face) + " is linked to " + name(to.entity(), to.face()) + ", which is not linked back";
}

std::string broken_involution(const GMap& map, int i, Dart dart) {
    const Dart other = map.alpha(i, dart);
    const Dart back = map.alpha(i, other);
    return "alpha" + std::to_string(i) + " is not an involution at " + name(dart) + ": it leads to " + name(other) +
           ", from where it leads to " + (back == Dart{} ? "an entity that is not local" : name(back));
}

std::optional<std::string> check_involution(const GMap& map, int i, Dart dart) {
    const Dart other = map.alpha(i, dart);
    if (other == Dart{} || map.alpha(i, other) == dart) {
        return std::nullopt;
    }
    return broken_involution(map, i, dart);
}

std::optional<std::string> check_composition(const GMap& map, int i, int j, Dart dart) {
    // alpha0 and alpha1 stay in the face, so if alpha3 is local at the first dart, it is local at all of them.
    if (j == 3 && map.alpha(3, dart) == Dart{}) {
        return std::nullopt;
    }
    const auto composed = [&](Dart d) { return map.alpha(j, map.alpha(i, d)); };
    if (composed(composed(dart)) == dart) {
        return std::nullopt;
    }
    return "alpha" + std::to_string(i) + " alpha" + std::to_string(j) + " is not an involution at " + name(dart);
}

std::optional<std::string> check_dart(const GMap& map, Dart dart) {
    for (int i = 0; i <= 3; ++i) {
        if (auto reason = check_involution(map, i, dart)) {
            return reason;
        }
    }
    for (const auto& [i, j] : {std::pair{0, 2}, std::pair{0, 3}, std::pair{1, 3}}) {
        if (auto reason = check_composition(map, i, j, dart)) {
            return reason;
        }
    }
    return std::nullopt;
}

bool corners_share_unions(LocalEntity entity, int face, FaceLink to,
                          const std::function<bool(LocalMass, LocalMass)>& share_union) {
    int k = 0;
    for (const LocalMass corner : corners_of(entity, face)) {
        if (!share_union(corner, corner_met(to, k++))) {
            return false;
        }
    }
    return true;
}

/// Calls check(entity, face) for all faces and returns the first reason found.
template <class Check>
std::optional<std::string> first_of_faces(const GMap& map, const Check& check) {
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; f < Cell::faces; ++f) {
            if (auto reason = check(e, f)) {
                return reason;
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> validate(const GMap& map) {
    if (auto reason = first_of_faces(map, [&](LocalEntity e, int f) { return check_target(map, e, f); })) {
        return reason;
    }
    return all_sides_agree(map) ? std::nullopt : validate_by_darts(map);
}

std::optional<std::string> validate_by_darts(const GMap& map) {
    if (auto reason = first_of_faces(map, [&](LocalEntity e, int f) { return check_target(map, e, f); })) {
        return reason;
    }
    for (Dart d{0}; d.value() < map.dart_count(); ++d) {
        if (auto reason = check_dart(map, d)) {
            return reason;
        }
    }
    return first_of_faces(map, [&](LocalEntity e, int f) { return check_return(map, e, f); });
}

std::optional<std::string> validate_sewing(const GMap& map, const std::function<bool(LocalEntity, int)>& is_checked,
                                           const std::function<bool(LocalMass, LocalMass)>& share_union) {
    return first_of_faces(map, [&](LocalEntity e, int f) -> std::optional<std::string> {
        const FaceLink to = map.link(e, f);
        if (!to.is_local() || !is_checked(e, f) || map.is_sewn(e, f) == corners_share_unions(e, f, to, share_union)) {
            return std::nullopt;
        }
        return name(e, f) + (map.is_sewn(e, f) ? " is sewn, but a pair of its corners does not share a union"
                                               : " is free, but all its corner pairs share their unions");
    });
}

}  // namespace cracksim::topology
