#include "physics/state/state.hpp"

namespace cracksim::physics {

namespace {

DupletSet active_duplets(const Network& network, const Fracture& fracture) {
    DupletSet active = network.duplets();
    fracture.inactive.for_each([&](LocalDuplet d) { active.erase(d); });
    return active;
}

}  // namespace

State::State(const Network& network, Scheme chosen, double dt, Precision precision, const Fracture& fracture)
    : scheme{chosen},
      step_size{dt},
      active{active_duplets(network, fracture)},
      unions{network, active},
      motion{unions.lattice(), chosen == Scheme::ab2, precision},
      held{network, unions} {
    for (const LocalUnion s : unions.advanced()) {
        motion.open(s);
        set_dt2_over_mass(network, s);
    }
    for (const LocalMass m : network.received()) {
        motion.open(unions.union_of(m));
    }
}

void State::set_dt2_over_mass(const Network& network, LocalUnion s) {
    double mass = 0;
    unions.for_each_mass(s, [&](LocalMass) { mass += network.model().corner_mass; });
    motion.set_dt2_over_mass(s, step_size * step_size / mass);
}

std::size_t State::memory_bytes() const {
    return active.memory_bytes() + unions.memory_bytes() + motion.memory_bytes() + held.memory_bytes();
}

Fracture fracture_of(const Network& network, const State& state) {
    Fracture fracture{DupletSet{network.interior_faces().size()}};
    network.duplets().for_each([&](LocalDuplet d) {
        if (!state.active.contains(d)) {
            fracture.inactive.insert(d);
        }
    });
    return fracture;
}

}  // namespace cracksim::physics
