#include "topology/cell_template.hpp"

#include <gtest/gtest.h>

#include <set>

namespace cracksim::topology {
namespace {

struct Tetrahedron {
    static constexpr int corners = 4;
    static constexpr int faces = 4;
    static constexpr int face_corners = 3;
    static constexpr std::array<std::array<int, face_corners>, faces> face{
        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
};

/// Four triangles, two of which coincide: edges 0-3 and 2-3 have one face each.
struct OpenTetrahedron {
    static constexpr int corners = 4;
    static constexpr int faces = 4;
    static constexpr int face_corners = 3;
    static constexpr std::array<std::array<int, face_corners>, faces> face{
        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 1, 2}}};
};

using TetrahedronCell = CellTemplate<Tetrahedron>;
static_assert(TetrahedronCell::darts == 24);
static_assert(TetrahedronCell::corner_darts == 6);
static_assert(axioms_hold<TetrahedronCell>());
static_assert(axioms_hold<HexahedronCell>());

template <class C>
class CellTemplateOf : public testing::Test {};
using Cells = testing::Types<HexahedronCell, TetrahedronCell>;
TYPED_TEST_SUITE(CellTemplateOf, Cells);

TYPED_TEST(CellTemplateOf, CornersShareTheDartsOut) {
    std::set<int> darts;
    for (int c = 0; c < TypeParam::corners; ++c) {
        for (const int d : TypeParam::darts_at(c)) {
            EXPECT_EQ(TypeParam::corner(d), c);
            EXPECT_TRUE(darts.insert(d).second);
        }
    }
    EXPECT_EQ(darts.size(), static_cast<std::size_t>(TypeParam::darts));
}

TYPED_TEST(CellTemplateOf, FacesAtACornerHaveItInTheirCycle) {
    for (int c = 0; c < TypeParam::corners; ++c) {
        std::set<int> faces;
        for (const auto& [face, place] : TypeParam::faces_at(c)) {
            EXPECT_EQ(TypeParam::corner_in_cycle(face, place), c);
            faces.insert(face);
        }
        EXPECT_EQ(faces.size(), 3U);
    }
}

TYPED_TEST(CellTemplateOf, DartNumberingIsABijection) {
    for (int d = 0; d < TypeParam::darts; ++d) {
        EXPECT_EQ(TypeParam::dart(TypeParam::face(d), TypeParam::place(d), TypeParam::end(d)), d);
    }
}

TYPED_TEST(CellTemplateOf, IsASphere) {
    const auto orbits = [](int i, int j) {
        std::set<std::set<int>> found;
        for (int d = 0; d < TypeParam::darts; ++d) {
            std::set<int> orbit;
            for (int at = d, step = 0; step < 2 * TypeParam::darts; ++step) {
                orbit.insert(at);
                at = TypeParam::alpha(step % 2 == 0 ? i : j, at);
            }
            found.insert(orbit);
        }
        return static_cast<int>(found.size());
    };
    EXPECT_EQ(orbits(1, 2), TypeParam::corners);
    EXPECT_EQ(orbits(0, 1), TypeParam::faces);
    EXPECT_EQ(orbits(1, 2) - orbits(0, 2) + orbits(0, 1), 2);
}

TEST(CellTemplate, FacesThatDoNotCloseBreakTheAxioms) {
    CellTables<OpenTetrahedron> tables;
    fill_within_faces(tables);
    const int on_edge_3_0 = DartNumbering<OpenTetrahedron>::dart(1, 2, 0);
    const int on_edge_0_1 = DartNumbering<OpenTetrahedron>::dart(1, 0, 0);
    EXPECT_EQ(find_alpha2(tables, on_edge_3_0), -1);
    EXPECT_NE(find_alpha2(tables, on_edge_0_1), -1);
}

}  // namespace
}  // namespace cracksim::topology
