#include "io/distributed_mesh.hpp"

#include <gtest/gtest.h>

#include "io/file_error.hpp"
#include "unit/io/scratch.hpp"
#include "unit/io/strip_mesh.hpp"

namespace cracksim::io {
namespace {

TEST(AgreedLayout, IsTheOneOfTheRanksWithCells) {
    const bool last = world().rank().value() == world().size() - 1;
    const partition::Communicator alone{MPI_COMM_SELF};
    const CellLayout layout = agreed_layout(world(), last ? point_mesh(alone, 2) : geometry::Mesh{});
    EXPECT_EQ(layout.kind, geometry::CellKind::point);
    ASSERT_EQ(layout.fields.size(), 1U);
    EXPECT_EQ(layout.fields[0].name, "speed");
    EXPECT_FALSE(layout.fields[0].integer);
}

TEST(AgreedLayout, RanksWithOtherFieldsAreRefusedOnAll) {
    if (world().size() == 1) {
        GTEST_SKIP() << "needs two ranks";
    }
    const partition::Communicator alone{MPI_COMM_SELF};
    geometry::Mesh mesh = strip_mesh(alone, 2, 0);
    if (!world().is_root()) {
        mesh.fields.back().name = "other";
    }
    EXPECT_THROW((void)agreed_layout(world(), mesh), FileError);
}

TEST(Gathered, RootHoldsWhatOneRankAloneWouldHold) {
    const geometry::Mesh mesh = strip_mesh(world(), 13, 0.1);
    const geometry::Mesh whole = gathered(world(), mesh, agreed_layout(world(), mesh));
    const partition::Communicator alone{MPI_COMM_SELF};
    const geometry::Mesh expected = world().is_root() ? strip_mesh(alone, 13, 0.1) : strip_mesh(alone, 0, 0);
    EXPECT_EQ(whole.points, expected.points);
    EXPECT_EQ(whole.connectivity, expected.connectivity);
    ASSERT_EQ(whole.fields.size(), 2U);
    EXPECT_EQ(whole.fields[0].values, expected.fields[0].values);
    EXPECT_EQ(whole.fields[1].values, expected.fields[1].values);
}

}  // namespace
}  // namespace cracksim::io
