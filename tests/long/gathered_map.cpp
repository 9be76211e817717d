#include "tests/long/gathered_map.hpp"

#include <algorithm>
#include <tuple>

#include "geometry/free_faces.hpp"
#include "topology/dart.hpp"
#include "topology/orbits.hpp"

namespace cracksim::test {

using simulation::Simulation;
using topology::Cell;
using topology::Dart;

namespace {

/// Bit i is set if the corner is on the upper side along axis i.
int corner_bits(int corner) {
    const auto& o = Hexahedron::offset[static_cast<std::size_t>(corner)];
    return o[0] + 2 * o[1] + 4 * o[2];
}

std::int64_t name_of(const Simulation& s, Dart dart) {
    if (dart == Dart{}) {
        return -1;
    }
    return dart_name(s.dynamics().decomposition().entities[entity_of(dart)].value(), flag_of(topology::in_cell(dart)));
}

}  // namespace

Flag flag_of(int in_cell) {
    const int face = Cell::face(in_cell);
    const int end = Cell::end(in_cell);
    const auto at = [&](int s) {
        return corner_bits(Cell::corner_in_cycle(face, (Cell::place(in_cell) + s) % Cell::face_corners));
    };
    const int along = at(end) ^ at(1 - end);
    return {at(end), along == 4 ? 2 : along / 2, face / 2};
}

std::vector<Links> gather_darts(const Simulation& s) {
    const auto& map = s.coat().map();
    std::vector<Links> here;
    for (Dart d{0}; d.value() < map.dart_count(); ++d) {
        if (s.dynamics().network().owned(entity_of(d))) {
            const auto to = [&](int i) { return name_of(s, map.alpha(i, d)); };
            here.push_back({name_of(s, d), {to(0), to(1), to(2), to(3)}});
        }
    }
    return s.comm().gather<Links>(here);
}

/// The owner of a union's smallest mass reports its split.
std::vector<PartedMass> gather_splits(const Simulation& s, const physics::SplitStream& splits) {
    const physics::Network& network = s.dynamics().network();
    std::vector<PartedMass> here;
    for (std::size_t n = 0; n < splits.size(); ++n) {
        const LocalMass smallest = splits.part(n, 0).front();
        for (std::size_t k = 0; network.owned(entity_of(smallest)) && k < splits.parts(n); ++k) {
            const std::int64_t part = network.mass(splits.part(n, k).front()).value();
            for (const LocalMass m : splits.part(n, k)) {
                here.push_back({splits.step(n), network.mass(smallest).value(), part, network.mass(m).value()});
            }
        }
    }
    auto all = s.comm().gather<PartedMass>(here);
    std::ranges::stable_sort(all, {}, [](const auto& m) { return std::tuple{m.step, m.old_union}; });
    return all;
}

std::int64_t free_face_count(const Simulation& s) {
    const auto& owned = s.dynamics().decomposition().owned;
    return s.comm().sum(static_cast<std::int64_t>(geometry::free_faces(s.coat().map(), owned.span()).size()));
}

std::int64_t vertex_count(const Simulation& s) {
    std::int64_t count = 0;
    const physics::Network& network = s.dynamics().network();
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        count += network.owned(entity_of(m)) && smallest_corner(s.coat().map(), m) == m ? 1 : 0;
    }
    return s.comm().sum(count);
}

}  // namespace cracksim::test
