#include "topology/face_link.hpp"

#include <gtest/gtest.h>

namespace cracksim::topology {
namespace {

TEST(FaceLink, HoldsEntityFaceAndRotation) {
    for (const std::int32_t e : {0, 1, 48999, FaceLink::entity_limit - 1}) {
        for (int f = 0; f < 6; ++f) {
            for (int r = 0; r < 4; ++r) {
                const FaceLink link = FaceLink::local(LocalEntity{e}, f, r);
                EXPECT_TRUE(link.is_local() && !link.is_boundary() && link != FaceLink::remote());
                EXPECT_EQ(link.entity(), LocalEntity{e});
                EXPECT_EQ(link.face(), f);
                EXPECT_EQ(link.rotation(), r);
            }
        }
    }
}

TEST(FaceLink, BoundaryAndRemoteAreNotLocal) {
    EXPECT_TRUE(FaceLink::boundary().is_boundary());
    EXPECT_FALSE(FaceLink::remote().is_local() || FaceLink::remote().is_boundary());
    EXPECT_FALSE(FaceLink::boundary().is_local() || FaceLink::remote().is_local());
    EXPECT_NE(FaceLink::boundary(), FaceLink::remote());
}

}  // namespace
}  // namespace cracksim::topology
