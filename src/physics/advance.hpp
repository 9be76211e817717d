#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physics/force_sweep.hpp"
#include "physics/network.hpp"
#include "physics/state.hpp"

namespace cracksim::physics {

/// What ranks tell each other of a mass before a step. Doubles throughout, which PetscSF packs several at a time.
struct NextMotion {
    Vec3 increment;  ///< of its union, by the coming advance, m
    double label;    ///< a small whole number (union_table.hpp)
};

/// One step of every union that this rank advances, from the forces of the last sweep:
///     w <- w + dt^2 F(u, w)/M,  u <- u + w,
/// and the forces at the new state. Both go row by row, so that a motion is read and written once. Held components take their
/// supports' motion, whose work is added to state.external. `received`: of the received masses, in the order of Network::received.
/// A union whose increment is not finite or longer than 100 edges is noted in state.breakdown. state.step becomes n + 1.
void advance(const Network& network, State& state, std::span<const NextMotion> received, Measure measure);

/// Finds what the coming advance does to the unions of some masses, with its bits. Keeps where they are from step to step.
class NextMotions {
public:
    NextMotions(const Lattice& lattice, std::vector<LocalMass> masses);

    [[nodiscard]] const std::vector<LocalMass>& masses() const { return masses_; }
    /// found[i] belongs to masses()[i].
    void find(const Network& network, const State& state, std::span<NextMotion> found) const;

private:
    /// The first mass of this list at the vertex is in the same union. Labels are known up to the mass.
    [[nodiscard]] bool is_told_before(std::span<const NextMotion> found, std::size_t i) const {
        return first_at_vertex_[i] < i && found[first_at_vertex_[i]].label == found[i].label;
    }
    /// Of some masses, by their indices.
    void find_increments(const Network& network, const State& state, std::span<const std::size_t> some,
                         std::span<NextMotion> found) const;
    template <class Real>
    void find_increments_in(const State& state, std::span<const std::size_t> some, std::span<NextMotion> found) const;

    std::vector<LocalMass> masses_;
    std::vector<VertexSite> vertex_;
    std::vector<std::size_t> first_at_vertex_;  ///< index of a mass
};

/// The start values of the received masses: w(0), and with ab2 its extrapolation.
struct StartIncrements {
    Vec3 increment;
    Vec3 extrapolated;
};
void set_received(const Network& network, State& state, std::span<const StartIncrements> increments);

/// The unions of the received masses by the labels that their owners give them, in the order of Network::received.
void set_received_labels(const Network& network, State& state, std::span<const NextMotion> received);

}  // namespace cracksim::physics
