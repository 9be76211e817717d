#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "physics/field.hpp"
#include "physics/network.hpp"
#include "physics/stability.hpp"
#include "physics/union_table.hpp"

namespace cracksim::physics {

/// Which duplets are active, and what the prefilter of the sensors needs of the force sweep.
struct Sensing {
    std::vector<std::uint8_t> active;  ///< by interface, bit k for duplet k; only duplets of touched unions
    /// [axis][entity]: no sensor over a face normal to the axis can trigger while the elongations (m) of the entity's four
    /// edges along it stay within this.
    std::array<std::vector<double>, 3> limit;
    std::array<std::vector<std::uint8_t>, 3> exceeded;  ///< [axis][batch], a bit an entity; written by the sweep

    [[nodiscard]] bool is_active(std::int32_t interface, int k) const {
        return ((static_cast<unsigned>(active[static_cast<std::size_t>(interface)]) >> static_cast<unsigned>(k)) &
                1U) != 0;
    }
    void inactivate(std::int32_t interface, int k) {
        auto& bits = active[static_cast<std::size_t>(interface)];
        bits = static_cast<std::uint8_t>(bits & ~(1U << static_cast<unsigned>(k)));
    }
};

/// A union held by supports: for each component the support that prescribes it, -1 if free.
struct Held {
    Slot slot;
    Vec3 rest;
    std::array<std::int16_t, 3> support;
};

/// The first union of this rank whose motion ceased to make sense.
struct Breakdown {
    std::int64_t step;
    MassId mass;  ///< its smallest mass
    bool finite;  ///< false: not a number or infinite
};

/// The state of this step. Per Mass-union: u, the displacement from rest, and w, the last increment, m.
struct State {
    State(const Network& network, Scheme scheme, double step_size);

    Scheme scheme;
    double step_size;  ///< dt, s
    std::int64_t step{0};
    UnionTable unions;
    Field displacement;                ///< u by slot
    Field increment;                   ///< w by slot
    Field extrapolated;                ///< ab2: 1.5 w(n) - 0.5 w(n-1) by slot; empty with cordis
    std::vector<double> mobility;      ///< dt^2/M by slot, s^2/kg
    Field force;                       ///< by slot, of the last sweep, N; whole for advanced unions only
    std::vector<double> owned_weight;  ///< by entity: 1 if owned, else 0
    Sensing sensing;
    std::vector<Held> held;
    std::vector<std::int32_t> held_of_slot;  ///< index into held, -1 if free
    double last_dissipation{0};              ///< J, z (v.n)^2 dt of the last sweep
    std::int64_t last_sweep{-1};             ///< its step
    double dissipated{0};  ///< J, by the owned entities since step 0: the trapezoidal sum of z (v.n)^2 dt
    double external{0};    ///< J, work of the supports on the unions that this rank owns so far
    double elastic{0};     ///< J, of the owned entities at the last measured sweep
    std::optional<Breakdown> breakdown;

    /// What damping takes for dt v: w, or its extrapolation with ab2.
    [[nodiscard]] const Field& velocity_increment() const { return scheme == Scheme::ab2 ? extrapolated : increment; }
    [[nodiscard]] double time() const { return static_cast<double>(step) * step_size; }
    /// Makes room after slots were appended.
    void fit();
    /// dt^2 over the sum of a union's masses.
    void set_mobility(const Network& network, Slot s);
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
