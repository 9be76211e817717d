#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/hexahedron.hpp"
#include "core/ids.hpp"
#include "core/vec3.hpp"
#include "physics/problem/duplets.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/state/listed_unions.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

enum class Measure : std::uint8_t { nothing, elastic_energy };

/// The first union of this rank whose increment is not finite or longer than 100 edges.
struct MotionFailure {
    std::int64_t step;
    MassId mass;  ///< its smallest mass
    bool finite;  ///< false: the increment is not a number or infinite
};

/// What a sweep over all local entities found. Energies are sums over the owned entities.
struct Swept {
    double dissipated{0};  ///< J, z (v.n)^2 dt at the state of the forces
    double elastic{0};     ///< J, where it was measured
    std::optional<MotionFailure> failure;
};

/// The forces on the corners of an entity, N.
using CornerForces = std::array<Vec3, Hexahedron::corners>;

/// Computes forces and advances motions. Called a few times a step; an implementation is compiled for its own layout of the
/// motion. It keeps caches that follow from network and state, so each engine serves one state, which it must be told of all
/// changes that it did not make itself.
class Engine {
public:
    virtual ~Engine() = default;

    /// The forces of all local entities, owned and halo alike, at the current state, summed over each union. Keeps no books,
    /// so a second call changes nothing.
    virtual Swept forces(State& state, Measure measure) = 0;
    /// One step of every union that this rank advances, from the forces of the state:
    ///     w <- w + dt^2 F(u, w)/M,  u <- u + w,
    /// and the forces at the new state. Held components take their supports' motion; the work is added to state.held. received:
    /// the next increments of the received masses, m, in the order of Network::received; of the masses of a union only the
    /// first one's is read. state.step becomes n + 1.
    virtual Swept advance(State& state, std::span<const Vec3> received, Measure measure) = 0;
    /// The increments of some touched unions in the coming advance, with its bits: increment i, m, is found[3 i], found[3 i + 1],
    /// found[3 i + 2].
    virtual void next_increments(const State& state, std::span<const ListedUnions::Entry> unions,
                                 std::span<double> found) const = 0;
    /// The forces on the corners of some entities (at most 8), each from its own interactions alone.
    virtual void corner_forces(const State& state, std::span<const LocalEntity> entities,
                               std::span<CornerForces> found) const = 0;
    /// The parts of masses changed at some vertices (`reparted`), and duplets became inactive or parts changed at some
    /// (`weakened`, which includes those). Each vertex is named once. May reorder the motion's pool.
    virtual void changed(State& state, std::span<const VertexSite> reparted, std::span<const VertexSite> weakened) = 0;
    /// The active duplets whose sensors may trigger at the state of the last forces, in any order, perhaps repeated. Exact: every
    /// sensor that triggers is among them.
    [[nodiscard]] virtual std::vector<LocalDuplet> may_trigger(const State& state) = 0;
    [[nodiscard]] virtual std::size_t memory_bytes() const = 0;

protected:
    Engine() = default;
    Engine(const Engine&) = default;
    Engine& operator=(const Engine&) = default;
    Engine(Engine&&) = default;
    Engine& operator=(Engine&&) = default;
};

}  // namespace cracksim::physics
