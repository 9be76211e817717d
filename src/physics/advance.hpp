#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physics/force_sweep.hpp"
#include "physics/network.hpp"
#include "physics/state.hpp"

namespace cracksim::physics {

/// One step of every union that this rank advances, from the forces of the last sweep:
///     w <- w + dt^2 F(u, w)/M,  u <- u + w,
/// and the forces at the new state. Both go row by row, so that a motion is read and written once. Held components take their
/// supports' motion, whose work is added to state.external. `received`: the new increments of the received masses, m, in the order of
/// Network::received. A union whose increment is not finite or longer than 100 edges is noted in state.breakdown.
/// state.step becomes n + 1.
void advance(const Network& network, State& state, std::span<const Vec3> received, Measure measure);

/// Finds the increments that the coming advance gives to the unions of some masses, with its bits. Keeps its lists from step to step.
class NextIncrements {
public:
    NextIncrements(const Lattice& lattice, std::vector<LocalMass> masses);

    [[nodiscard]] const std::vector<LocalMass>& masses() const { return masses_; }
    void find(const Network& network, const State& state);
    /// Of masses()[i], m, at the state of the last find.
    [[nodiscard]] Vec3 increment(std::size_t i) const { return next_[i]; }

private:
    [[nodiscard]] Slot slot(const State& state, std::size_t i) const {
        return slot_of(vertex_[i], state.unions.label(masses_[i]));
    }
    template <class Real>
    void find_some(const State& state, std::size_t first, std::size_t count);

    std::vector<LocalMass> masses_;
    std::vector<VertexSite> vertex_;
    std::vector<Vec3> next_;
};

/// The start values of the received masses: w(0), and with ab2 its extrapolation.
struct StartIncrements {
    Vec3 increment;
    Vec3 extrapolated;
};
void set_received(const Network& network, State& state, std::span<const StartIncrements> increments);

/// The unions of the received masses by the labels that their owners give them, in the order of Network::received.
void set_received_labels(const Network& network, State& state, std::span<const std::uint8_t> labels);

}  // namespace cracksim::physics
