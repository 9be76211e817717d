#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/hexahedron.hpp"
#include "core/ids.hpp"
#include "core/symmetric_tensor.hpp"
#include "core/vec3.hpp"
#include "physics/measure.hpp"
#include "physics/problem/duplets.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/state/listed_unions.hpp"
#include "physics/state/state.hpp"
#include "physics/state/union_sums.hpp"

namespace cracksim::physics {

/// A union of this rank whose increment is not finite or longer than 100 edges: of several, the one with the smallest
/// mass.
struct MotionFailure {
    std::int64_t step;
    MassId mass;  ///< its smallest mass
    bool finite;  ///< false: the increment is not a number or infinite
};

/// The results of a sweep over all local entities: sums over the owned ones.
struct Swept {
    double dissipated{0};  ///< J, z (v.n)^2 dt at the state of the forces
    double elastic{0};     ///< J; 0 if it was not measured
    /// J, what the dashpots take from step n to n+1, after an advance with Measure::all: -(D(n) + D(n+1)).w(n+1)/2 with
    /// their forces D on the unions. None if the engine has nothing better than `dissipated`. No sweep knows D(n) and
    /// w(n+1) together. With the forces F = D + f of dashpots and springs it is
    ///     [f(n).w(n+1) - D(n+1).w(n+1)]/2, a sum over entities, - F(n).w(n+1)/2, a sum over owned unions.
    std::optional<double> over_step;
    std::optional<MotionFailure> failure;
};

/// The forces on the corners of an entity, N.
using CornerForces = std::array<Vec3, Hexahedron::corners>;

/// Computes forces and advances motions. A step makes only a few virtual calls: the loops over entities and unions are
/// inside each engine. An engine keeps caches that follow from network and state. So an engine serves
/// one state, and changed() must follow every change of unions or duplets.
class Engine {
public:
    virtual ~Engine() = default;

    /// Computes the forces of all local entities, owned and halo alike, at the current state, and sums them over each
    /// union. The engine adds up no energies over time, so a second call changes nothing.
    virtual Swept forces(State& state, Measure measure) = 0;
    /// Advances every union of this rank by one step, from the forces of the state:
    ///     w <- w + dt^2 F(u, w)/M,  u <- u + w,
    /// and computes the forces at the new state. Held components move as their supports prescribe; their work
    /// R(n).(w(n) + w(n+1))/2, with the forces R of the supports, is added to state.held. received: the next
    /// increments of the received masses, m, in the order of Network::received; of each union, only the increment of
    /// the first mass is read. state.step becomes n + 1.
    virtual Swept advance(State& state, std::span<const Vec3> received, Measure measure) = 0;
    /// Computes the increments that the next advance will give to some touched unions, bit for bit: increment i, m, is
    /// found[3 i], found[3 i + 1], found[3 i + 2].
    virtual void next_increments(const State& state, std::span<const ListedUnions::Entry> unions,
                                 std::span<double> found) const = 0;
    /// Computes the forces on the corners of some entities (at most 8), each from the entity's own interactions alone.
    virtual void corner_forces(const State& state, std::span<const LocalEntity> entities,
                               std::span<CornerForces> found) const = 0;
    /// Updates the caches. reparted: the vertices where parts of masses changed. weakened: the vertices where duplets
    /// became inactive, and those of `reparted`. Each list contains a vertex once. May reorder the motion's pool.
    virtual void changed(State& state, std::span<const VertexSite> reparted, std::span<const VertexSite> weakened) = 0;
    /// Sensors `normal`: the active duplets whose sensors may trigger at the state of the last forces, in any order; a
    /// duplet may occur twice. Every duplet whose sensor triggers is among them.
    [[nodiscard]] virtual std::vector<LocalDuplet> may_trigger(const State& state) = 0;
    /// Sensors `stress`: the interior faces with active duplets that open at the state of the last forces, ascending,
    /// each once (fracture/stress_sensor.hpp).
    [[nodiscard]] virtual std::vector<std::int32_t> opening_faces(const State& state) = 0;
    /// The elastic stresses of some entities in their rest frames, over Young's modulus. The bits of each depend only
    /// on the network and the displacements of the entity's corners.
    [[nodiscard]] virtual std::vector<SymmetricTensor> stresses(const State& state,
                                                                std::span<const LocalEntity> entities) const = 0;
    /// Sums over the owned unions. The state must have the forces of the current step; splits do not change the sums.
    [[nodiscard]] virtual UnionSums sums(const State& state) const = 0;
    [[nodiscard]] virtual std::size_t memory_bytes() const = 0;

protected:
    Engine() = default;
    Engine(const Engine&) = default;
    Engine& operator=(const Engine&) = default;
    Engine(Engine&&) = default;
    Engine& operator=(Engine&&) = default;
};

}  // namespace cracksim::physics
