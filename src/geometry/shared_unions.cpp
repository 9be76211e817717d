#include "geometry/shared_unions.hpp"

namespace cracksim::geometry {

SharedUnions::SharedUnions(std::size_t masses) : next_(masses) {
    for (LocalMass m{0}; m.index() < masses; ++m) {
        next_[m] = m;
    }
}

void SharedUnions::set(std::span<const LocalMass> masses) {
    LocalMass last = masses.empty() ? LocalMass{} : masses.back();
    for (const LocalMass m : masses) {
        next_[last] = m;
        last = m;
    }
}

bool SharedUnions::joins(LocalEntity a, LocalEntity b) const {
    for (int corner = 0; corner < Hexahedron::corners; ++corner) {
        const LocalMass mass = local_mass(a, corner);
        for (LocalMass m = next_[mass]; m != mass; m = next_[m]) {
            if (entity_of(m) == b) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace cracksim::geometry
