#include "physics/measure.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "physics/state/hashes.hpp"
#include "support/body.hpp"
#include "support/precisions.hpp"
#include "support/random_state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// Runs a block that cracks and returns the hashes of its motion after each step.
template <class AnyBody>
std::vector<std::uint64_t> motions(const Network& network, Scheme scheme, Precision precision, Measure measure) {
    AnyBody body{network, scheme, 0.1, precision};
    test::shake(body.state, 0.03, 5);
    body.forces();
    std::vector<std::uint64_t> found;
    SplitStream splits;
    for (int step = 0; step < 40; ++step) {
        body.split(body.sense(), splits);
        body.advance(measure);
        std::uint64_t sum = 0;
        for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
            sum += motion_hash(body.state, m);
        }
        found.push_back(sum);
    }
    EXPECT_GT(splits.size(), 10U);
    return found;
}

template <class AnyBody>
void expect_the_same_motion(const test::SerialBlock& block) {
    const Network network = block.network();
    for (const Scheme scheme : {Scheme::cordis, Scheme::ab2}) {
        for (const Precision precision : test::both_precisions) {
            const auto plain = motions<AnyBody>(network, scheme, precision, Measure::nothing);
            EXPECT_EQ(motions<AnyBody>(network, scheme, precision, Measure::elastic_energy), plain);
            EXPECT_EQ(motions<AnyBody>(network, scheme, precision, Measure::all), plain);
        }
    }
}

TEST(Measure, ChangesNoBitOfTheMotion) {
    test::SerialBlock block;
    block.cells = {19, 4, 3};
    block.thresholds = {[](Vec3 x) { return x.x < 6 ? 0.03 : std::numeric_limits<double>::infinity(); }, std::nullopt};
    expect_the_same_motion<test::Body>(block);
    block.solid = Solid{1, 0.25, 1, 0.05};
    expect_the_same_motion<test::StandardBody>(block);
}

}  // namespace
}  // namespace cracksim::physics
