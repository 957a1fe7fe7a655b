// Points are read where they lie, in any layout.
#include "core/spline/points_view.h"

#include "core/spline/curve.h"
#include "tests/property/random_curves.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <span>

namespace splineloft {
namespace {

struct Mark {
    std::uint8_t colour;
    float height;
    double north, east;
};

const Points table = {{1.5, -2}, {3, 0.25}, {-7, 11}};

void expectTable(const PointsView& view) {
    ASSERT_EQ(view.size(), table.size());
    ASSERT_EQ(view.dimension(), 2);
    for (std::size_t i = 0; i < table.size(); ++i) {
        EXPECT_EQ(view.at(i), table.at(i)) << "point " << i;
    }
}

TEST(PointsView, readsEveryLayout) {
    expectTable(table);
    expectTable(std::array<glm::dvec2, 3>{{{1.5, -2}, {3, 0.25}, {-7, 11}}});
    expectTable(std::vector<glm::vec2>{{1.5F, -2}, {3, 0.25F}, {-7, 11}});
    const std::vector<std::array<double, 2>> arrays = {{1.5, -2}, {3, 0.25}, {-7, 11}};
    expectTable(arrays);
    expectTable(std::span(arrays));
    const std::vector<Mark> marks = {{1, 0, -2, 1.5}, {2, 0, 0.25, 3}, {3, 0, 11, -7}};
    expectTable(PointsView::of(marks, &Mark::east, &Mark::north));
    const std::array<double, 9> padded = {1.5, -2, 99, 3, 0.25, 99, -7, 11, 99};
    expectTable(PointsView(padded.data(), 3, 2, 3 * sizeof(double)));
}

TEST(PointsView, readsPointsOnALineAndInSpace) {
    const std::vector<double> heights = {4, 5, -6};
    EXPECT_EQ(PointsView(heights).dimension(), 1);
    EXPECT_EQ(PointsView(heights).at(2), Point({-6}));
    const std::vector<glm::dvec3> space = {{1, 2, 3}, {4, 5, 7}};
    EXPECT_EQ(PointsView(space).at(1), Point({4, 5, 7}));
    const std::vector<Mark> marks = {{1, 2.5F, -2, 1.5}};
    EXPECT_EQ(PointsView::of(marks, &Mark::height).at(0), Point({2.5}));
}

TEST(PointsView, mayBeEmpty) {
    EXPECT_TRUE(PointsView(std::vector<glm::dvec2>()).empty());
    EXPECT_TRUE(PointsView::of(std::vector<Mark>(), &Mark::east).empty());
    EXPECT_TRUE(piecesOf(Spline(), std::vector<glm::dvec2>()).empty());
}

/// The same spline through the same points is the same curve, wherever they lie.
TEST(PointsView, blendsAsATableOfOursDoes) {
    for (const auto& id : testing_curves::familyIds()) {
        testing_curves::forEveryForm(id, 3, [](const Curve& curve) {
            const auto width = static_cast<std::size_t>(curve.points.dimension());
            std::vector<double> apart;
            for (std::size_t i = 0; i < curve.points.size(); ++i) {
                const auto row = curve.points[i];
                apart.insert(apart.end(), row.begin(), row.end());
                apart.insert(apart.end(), {1e300, -1e300}); // nobody may read this
            }
            const PointsView view(apart.data(), curve.points.size(), curve.points.dimension(),
                                  (width + 2) * sizeof(double));
            const auto theirs = piecesOf(curve, view, curve.tangents);
            EXPECT_TRUE(std::ranges::equal(piecesOf(curve).bezier(), theirs.bezier()));
        });
    }
}

} // namespace
} // namespace splineloft
