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

}  // namespace cracksim::geometry
