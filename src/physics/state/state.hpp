#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "physics/lattice/edge_limits.hpp"
#include "physics/lattice/sweep/sweep_view.hpp"
#include "physics/lattice/shared_edges.hpp"
#include "physics/state/motion.hpp"
#include "physics/problem/network.hpp"
#include "physics/lattice/pooled_corners.hpp"
#include "physics/lattice/received_unions.hpp"
#include "physics/problem/stability.hpp"
#include "physics/state/unions.hpp"

namespace cracksim::physics {

/// Which duplets are active, and what the prefilter of the sensors needs of the force sweep.
struct Sensing {
    /// Counts the changes at a vertex: at most twelve, as each takes one of its duplets.
    using Revision = std::uint8_t;

    std::vector<std::uint8_t> active;  ///< by interior face, bit k for duplet k; only duplets of touched unions
    EdgeLimits limits;
    std::vector<EdgeBits> exceeded;  ///< [batch]: edges stretched beyond their limits; written by the sweep
    /// By vertex: rises when sensors at its edges, or what they reach over, become others
    std::vector<Revision> revision;

    [[nodiscard]] bool is_active(LocalDuplet d) const {
        return ((static_cast<unsigned>(active[d.index() / Network::duplets_per_face]) >>
                 static_cast<unsigned>(d.value() % Network::duplets_per_face)) &
                1U) != 0;
    }
    void inactivate(LocalDuplet d) {
        auto& bits = active[d.index() / Network::duplets_per_face];
        bits = static_cast<std::uint8_t>(bits &
                                         ~(1U << static_cast<unsigned>(d.value() % Network::duplets_per_face)));
    }
};

/// A union held by supports: for each component the support that prescribes it, -1 if free.
struct HeldUnion {
    LocalUnion local_union;
    Vec3 rest;
    std::array<std::int16_t, 3> support;
};

/// The first union of this rank whose motion ceased to make sense.
struct MotionFailure {
    std::int64_t step;
    MassId mass;  ///< its smallest mass
    bool finite;  ///< false: not a number or infinite
};

/// The state of this step. Per Mass-union: u, the displacement from rest, and w, the last increment, m.
struct State {
    State(const Network& network, Scheme scheme, double step_size, Precision precision = Precision::binary64);

    Scheme scheme;
    double step_size;  ///< dt, s
    std::int64_t step{0};
    Unions unions;
    Motion motion;
    PooledHalves pooled;
    SharedEdges shared_edges;
    Sensing sensing;
    std::vector<HeldUnion> held;
    std::unordered_map<LocalUnion, std::size_t> held_of_slot;  ///< index into held
    std::vector<std::vector<std::size_t>> held_in_row;   ///< by vertex row: indices into held
    ReceivedUnions received;
    double last_dissipation{0};   ///< J, z (v.n)^2 dt of the last sweep
    std::int64_t last_sweep{-1};  ///< its step
    double dissipated{0};         ///< J, by the owned entities since step 0: the trapezoidal sum of z (v.n)^2 dt
    double external{0};           ///< J, work of the supports on the unions that this rank owns so far
    double elastic{0};            ///< J, of the owned entities at the last measured sweep
    std::optional<MotionFailure> failure;

    [[nodiscard]] const Lattice& lattice() const { return unions.lattice(); }
    [[nodiscard]] double time() const { return static_cast<double>(step) * step_size; }

    [[nodiscard]] Vec3 displacement(LocalUnion s) const { return motion.get(s, Quantity::displacement); }
    [[nodiscard]] Vec3 increment(LocalUnion s) const { return motion.get(s, Quantity::increment); }
    /// The sum of the forces on the union's masses, N, of the last sweep.
    [[nodiscard]] Vec3 force(LocalUnion s) const { return motion.get(s, Quantity::force); }
    /// dt^2/M, s^2/kg.
    [[nodiscard]] double dt2_over_mass(LocalUnion s) const { return motion.dt2_over_mass(s); }
    /// What damping takes for dt v: w, or with ab2 1.5 w(n) - 0.5 w(n-1).
    [[nodiscard]] Vec3 velocity_increment(LocalUnion s) const { return motion.get(s, velocity_quantity()); }
    [[nodiscard]] std::size_t velocity_quantity() const {
        return scheme == Scheme::ab2 ? Quantity::extrapolated : Quantity::increment;
    }
    void set_displacement(LocalUnion s, Vec3 u) { motion.set(s, Quantity::displacement, u); }
    void set_increment(LocalUnion s, Vec3 w) { motion.set(s, Quantity::increment, w); }
    void set_force(LocalUnion s, Vec3 f) { motion.set(s, Quantity::force, f); }
    void set_velocity_increment(LocalUnion s, Vec3 w) { motion.set(s, velocity_quantity(), w); }

    /// dt^2 over the sum of a union's masses.
    void set_dt2_over_mass(const Network& network, LocalUnion s);
    /// Brings where corners are and who carries edges up to date at some vertices, each named once, where masses changed their unions.
    void update_unions(std::span<const VertexSite> vertices);
    /// A union is held from now on.
    void hold(const HeldUnion& union_held);
    [[nodiscard]] std::size_t memory_bytes() const;
};

/// Initial fields of the rest position: displacement (m), velocity (m/s).
struct Initial {
    std::function<Vec3(Vec3)> displacement;
    std::function<Vec3(Vec3)> velocity;
};

/// Sets u(0) everywhere and w(0) of the advanced unions: x(-1) = x0 - dt v0 + dt^2 a0 / 2, so w(0) = dt v0 - dt^2 a0 / 2, and
/// for ab2 w(-1) = dt v0 - 3 dt^2 a0 / 2. The increments of received masses come by exchange afterwards.
/// All masses of a union rest at one place, so the mean of their initial velocities is the field's value there.
void start(const Network& network, const Initial& initial, State& state);

}  // namespace cracksim::physics
