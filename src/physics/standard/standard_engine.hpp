#pragma once

#include "physics/engine.hpp"
#include "physics/standard/standard_caches.hpp"

namespace cracksim::physics {

/// The engine for standard entities on a regular lattice: SIMD sweeps over rows of entities along x. A copy of the
/// engine serves a copy of the state.
class StandardEngine final : public Engine {
public:
    /// The engine serves this state. network must outlive this.
    StandardEngine(const Network& network, const State& state) : network_{&network}, caches_{network, state} {}

    Swept forces(State& state, Measure measure) override;
    Swept advance(State& state, std::span<const Vec3> received, Measure measure) override;
    void next_increments(const State& state, std::span<const ListedUnions::Entry> unions,
                         std::span<double> found) const override;
    void corner_forces(const State& state, std::span<const LocalEntity> entities,
                       std::span<CornerForces> found) const override;
    void changed(State& state, std::span<const VertexSite> reparted, std::span<const VertexSite> weakened) override;
    [[nodiscard]] std::vector<LocalDuplet> may_trigger(const State& state) override;
    [[nodiscard]] std::vector<std::int32_t> opening_faces(const State& state) override;
    [[nodiscard]] std::vector<SymmetricTensor> stresses(const State& state,
                                                        std::span<const LocalEntity> entities) const override;
    [[nodiscard]] UnionSums sums(const State& state) const override;
    [[nodiscard]] std::size_t memory_bytes() const override { return caches_.memory_bytes(); }

    [[nodiscard]] const StandardCaches& caches() const { return caches_; }

private:
    const Network* network_;
    StandardCaches caches_;
};

}  // namespace cracksim::physics
