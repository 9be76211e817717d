#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/hexahedron.hpp"
#include "core/vec3.hpp"
#include "physics/problem/network.hpp"
#include "physics/problem/stability.hpp"
#include "physics/state/fracture.hpp"
#include "physics/state/held_unions.hpp"
#include "physics/state/motion.hpp"
#include "physics/state/unions.hpp"

namespace cracksim::physics {

/// The state at the current step. For each Mass-union: u, the displacement from rest, and w, the last increment, in m.
/// The state holds all data that a continuation needs. Unions, held unions and the layout of the motion follow from the
/// active duplets, and forces from the motion; they are kept because every step needs them.
struct State {
    /// A body at rest with this fracture. The unions of received masses count as whole until the parts that their
    /// owners send are set (fracture/received_parts.hpp).
    State(const Network& network, Scheme scheme, double step_size, Precision precision = Precision::binary64,
          const Fracture& fracture = {});

    Scheme scheme;
    double step_size;  ///< dt, s
    std::int64_t step{0};
    DupletSet active;  ///< the active duplets of the network
    Unions unions;
    Motion motion;
    HeldUnions held;

    [[nodiscard]] const Lattice& lattice() const { return unions.lattice(); }
    [[nodiscard]] double time() const { return static_cast<double>(step) * step_size; }

    [[nodiscard]] Vec3 displacement(LocalUnion s) const { return motion.get(s, Quantity::displacement); }
    [[nodiscard]] Vec3 increment(LocalUnion s) const { return motion.get(s, Quantity::increment); }
    /// The displacements of an entity's corners, m.
    [[nodiscard]] std::array<Vec3, Hexahedron::corners> corner_displacements(LocalEntity e) const {
        std::array<Vec3, Hexahedron::corners> u;
        for (int corner = 0; corner < Hexahedron::corners; ++corner) {
            u[static_cast<std::size_t>(corner)] = displacement(unions.union_of(local_mass(e, corner)));
        }
        return u;
    }
    /// The sum of the forces on the union's masses at the current state, N.
    [[nodiscard]] Vec3 force(LocalUnion s) const { return motion.get(s, Quantity::force); }
    /// dt^2/M, s^2/kg.
    [[nodiscard]] double dt2_over_mass(LocalUnion s) const { return motion.dt2_over_mass(s); }
    /// The value of dt v that damping uses, m: w, or for ab2 the extrapolated increment 1.5 w(n) - 0.5 w(n-1).
    [[nodiscard]] Vec3 velocity_increment(LocalUnion s) const { return motion.get(s, velocity_quantity()); }
    [[nodiscard]] std::size_t velocity_quantity() const {
        return scheme == Scheme::ab2 ? Quantity::extrapolated : Quantity::increment;
    }
    void set_displacement(LocalUnion s, Vec3 u) { motion.set(s, Quantity::displacement, u); }
    void set_increment(LocalUnion s, Vec3 w) { motion.set(s, Quantity::increment, w); }
    void set_force(LocalUnion s, Vec3 f) { motion.set(s, Quantity::force, f); }
    void set_velocity_increment(LocalUnion s, Vec3 w) { motion.set(s, velocity_quantity(), w); }
    /// Computes dt^2 over the sum of a union's masses.
    void set_dt2_over_mass(const Network& network, LocalUnion s);
    [[nodiscard]] std::size_t memory_bytes() const;
};

/// The fracture of a state: the duplets of the network that are inactive.
[[nodiscard]] Fracture fracture_of(const Network& network, const State& state);

}  // namespace cracksim::physics
