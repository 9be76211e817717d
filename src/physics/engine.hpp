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

/// A union of this rank whose increment is not finite or longer than 100 edges: of several, the one with the smallest
/// mass.
struct MotionFailure {
    std::int64_t step;
    MassId mass;  ///< its smallest mass
    bool finite;  ///< false: the increment is not a number or infinite
};

/// The results of a sweep over all local entities. `dissipated` and `elastic` are sums over the interactions of the
/// owned entities. How dissipation follows from `dissipated` and `kick`: dynamics/energy_book.hpp.
struct Swept {
    /// J, sum of  z/dt (dw.n)(de.n) + k [r^3 (dw.d')^2 / L0^2 + (1 - r) dw.dw] / 2  at the state of the forces: w is
    /// the last increment, e the one that damping uses, d' = d - dw/2 and r = L0/|d|. The second term is half the
    /// change of the elastic force over the last increment, times the increment. It is zero in a rotation without
    /// strain.
    double dissipated{0};
    double elastic{0};  ///< J; 0 if it was not measured
    double kick{0};     ///< J, sum over the owned unions of F(n).(w(n+1) - w(n)), after an advance
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
    /// The active duplets whose sensors may trigger at the state of the last forces, in any order; a duplet may occur
    /// twice. Every duplet whose sensor triggers is among them.
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
