#pragma once

#include <cstddef>
#include <span>

#include "core/vec3.hpp"
#include "physics/lattice/force_sweep.hpp"
#include "physics/state/listed_unions.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// One step of every union that this rank advances, from the forces of the last sweep:
///     w <- w + dt^2 F(u, w)/M,  u <- u + w,
/// and the forces at the new state. Both go row by row, so that a motion is read and written once. HeldUnion components take their
/// supports' motion, whose work is added to state.external. received: the next increments of the received masses, m, in the order of
/// Network::received; of the masses of a union only the first's is read.
/// A union whose increment is not finite or longer than 100 edges is noted in state.breakdown. state.step becomes n + 1.
void advance(const Network& network, State& state, std::span<const Vec3> received, Measure measure);

/// What the coming advance does to some touched unions, with its bits: increment i, m, is found[3 i], found[3 i + 1], found[3 i + 2].
void find_next_increments(const Network& network, const State& state, std::span<const ListedUnions::Entry> unions,
                          std::span<double> found);

/// The start values of the received masses: w(0), and with ab2 its extrapolation.
struct StartIncrements {
    Vec3 increment;
    Vec3 extrapolated;
};
void set_received(const Network& network, State& state, std::span<const StartIncrements> increments);

/// What the owner says of the union of a received mass.
struct ReceivedPart {
    std::size_t mass;  ///< index into Network::received
    int label;
};
/// Takes over new labels of received masses, in any order.
void set_received_parts(const Network& network, State& state, std::span<const ReceivedPart> labels);

}  // namespace cracksim::physics
