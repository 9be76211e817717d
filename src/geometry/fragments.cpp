#include "geometry/fragments.hpp"

namespace cracksim::geometry {

void join_union(topology::DisjointSets& entities, std::span<const LocalMass> masses) {
    for (const LocalMass mass : masses) {
        entities.join(entity_of(masses.front()).index(), entity_of(mass).index());
    }
}

}  // namespace cracksim::geometry
