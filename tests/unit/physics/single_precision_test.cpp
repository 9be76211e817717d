#include "physics/single_precision.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

std::string unfit(const test::SerialBlock& block, double step_size) {
    return unfit_for_single_precision(block.model(), step_size).value_or("");
}

TEST(SinglePrecision, TakesBlocksOfAnyUsualSize) {
    EXPECT_EQ(unfit({}, 0.3), "");
    test::SerialBlock atoms;
    atoms.edge = {1e-9, 1e-9, 1e-9};
    atoms.corner_mass = 1e-25;
    atoms.edges = {20, 1e-12};
    atoms.diagonals = {0, 0};
    EXPECT_EQ(unfit(atoms, 1e-14), "");
}

TEST(SinglePrecision, NamesWhatItCannotHold) {
    test::SerialBlock stiff;
    stiff.edges.stiffness = 1e40;
    EXPECT_EQ(unfit(stiff, 0.3), "the stiffness of an interaction, 1e+40 N/m");
    test::SerialBlock viscous;
    viscous.edges.viscosity = 1e22;
    EXPECT_EQ(unfit(viscous, 1e-4), "the viscosity of an interaction over step and squared length, 1e+26 N/m3");
    test::SerialBlock heavy;
    heavy.corner_mass = 1e30;
    EXPECT_EQ(unfit(heavy, 1), "the squared step over a mass, 1e-30 s2/kg");
}

}  // namespace
}  // namespace cracksim::physics
