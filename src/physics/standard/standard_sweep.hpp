#pragma once

#include <span>
#include <variant>
#include <vector>

#include "physics/engine.hpp"
#include "physics/standard/standard_caches.hpp"
#include "physics/standard/sweep/standard_view.hpp"

namespace cracksim::physics {

/// One sweep over all rows of standard entities, in ascending order, which adds their forces to the unions. The force
/// on a union is the sum over its masses, in ascending order of their ids. It is complete after the last row that meets
/// its vertex. Entities share nothing, so the forces of an entity depend on its own corners alone.
class StandardSweep {
public:
    /// Keeps references to the arguments. Serves one sweep.
    StandardSweep(const Network& network, State& state, StandardCaches& caches, Measure measure);

    /// Also marks the entities that are stressed beyond their limits, in StandardCaches::stretched.
    void sweep_row(std::size_t row);
    /// The energies of the owned entities in the rows swept so far.
    [[nodiscard]] Swept found() const;

private:
    const Lattice* lattice_;
    Measure measure_;
    std::variant<StandardView<double>, StandardView<float>> view_;
};

/// Engine::corner_forces for standard entities.
void find_standard_corner_forces(const Network& network, const State& state, std::span<const LocalEntity> entities,
                                 std::span<CornerForces> found);

/// The elastic stresses of some entities over E, with the bits that the sweep gives.
[[nodiscard]] std::vector<SymmetricTensor> find_standard_stresses(const Network& network, const State& state,
                                                                  std::span<const LocalEntity> entities);

}  // namespace cracksim::physics
