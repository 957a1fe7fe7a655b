// SVG path data as curves: tricky paths with what is known of them.
#include "core/formats/svg_path.h"

#include "core/spline/measure/bounds.h"
#include "core/spline/measure/length.h"
#include "core/spline/problem.h"
#include "tests/property/random_curves.h"

#include <cmath>
#include <numbers>

namespace splineloft {
namespace {

using namespace testing_curves;
constexpr double pi = std::numbers::pi;

std::vector<Curve> drawn(const std::string& data) {
    auto curves = curvesFromPathData(data);
    EXPECT_TRUE(curves) << data << ": " << curves.refusal().message();
    for (const auto& curve : curves ? *curves : std::vector<Curve>()) {
        EXPECT_FALSE(problemOf(curve)) << data;
    }
    return curves ? *curves : std::vector<Curve>();
}

Curve drawnAlone(const std::string& data) {
    const auto curves = drawn(data);
    EXPECT_EQ(curves.size(), 1u) << data;
    return curves.empty() ? Curve() : curves.front();
}

struct Known {
    std::string data;
    std::string family;
    bool closed;
    std::size_t points;
    Point last;
    double length;
};

void PrintTo(const Known& known, std::ostream* out) {
    *out << known.data;
}

class KnownPath : public testing::TestWithParam<Known> {};

TEST_P(KnownPath, isTheCurveThatItIs) {
    const auto& known = GetParam();
    const Curve curve = drawnAlone(known.data);
    EXPECT_EQ(curve.family, known.family);
    EXPECT_EQ(curve.closed, known.closed);
    ASSERT_EQ(curve.points.size(), known.points);
    expectNear(curve.points.at(curve.points.size() - 1), known.last, 1e-12, "last point");
    EXPECT_NEAR(lengthOf(piecesOf(curve)), known.length, 1e-3 * known.length);
}

const std::string polygon = "linear";
const std::string spline = "bezier-spline";

INSTANTIATE_TEST_SUITE_P(Svg, KnownPath,
                         testing::ValuesIn(std::vector<Known>{
                             {"M1 2L4 6", polygon, false, 2, {4, 6}, 5},
                             {"m1 2l3 4", polygon, false, 2, {4, 6}, 5},
                             {"M1,2 4,6 4,16", polygon, false, 3, {4, 16}, 15},
                             {"m1,2 3,4 0,10", polygon, false, 3, {4, 16}, 15},
                             {"  \n M 1 2 \t L 4 6 \r\n ", polygon, false, 2, {4, 6}, 5},
                             {"M0 0H3V4h-3z", polygon, true, 4, {0, 4}, 14},
                             {"M0 0H3 5 7", polygon, false, 4, {7, 0}, 7},
                             {"M0 0h3 5v7-2", polygon, false, 5, {8, 5}, 17},
                             {"M0 0 3 0 3 4 0 0z", polygon, true, 3, {3, 4}, 12},
                             {"M0 0 3 0 3 4Z", polygon, true, 3, {3, 4}, 12},
                             {"M.5.5.5-1", polygon, false, 2, {0.5, -1}, 1.5},
                             {"M1.5.5-1.5.5", polygon, false, 2, {-1.5, 0.5}, 3},
                             {"M1e1-1E1L1e+1,20e-1", polygon, false, 2, {10, 2}, 12},
                             {"M+1+2L+4+6", polygon, false, 2, {4, 6}, 5},
                             {"M1. 2.L4. 6.", polygon, false, 2, {4, 6}, 5},
                             {"M0 0L1 0M5 5", polygon, false, 2, {1, 0}, 1},
                             {"M0 0M5 5L5 9", polygon, false, 2, {5, 9}, 4},
                             {"M0 0C1 0 2 0 3 0", spline, false, 4, {3, 0}, 3},
                             {"M1 1c1 0 2 0 3 0 1 0 2 0 3 0", spline, false, 7, {7, 1}, 6},
                             {"M0 0C0 1 1 2 2 2S4 3 4 4", spline, false, 7, {4, 4}, 6.195472},
                             {"M0 0S1 0 3 0", spline, false, 4, {3, 0}, 3},
                             {"M0 0Q1.5 0 3 0", spline, false, 4, {3, 0}, 3},
                             {"M0 0q1 0 2 0t2 0 2 0", spline, false, 10, {6, 0}, 6},
                             {"M0 0T4 0", spline, false, 4, {4, 0}, 4},
                             {"M0 0L2 0T4 0", spline, false, 7, {4, 0}, 4},
                             {"M0 0A5 5 0 0 1 10 0", spline, false, 7, {10, 0}, 5 * pi},
                             {"M0 0a5 5 0 01 10 0", spline, false, 7, {10, 0}, 5 * pi},
                             {"M0 0a5,5 0 1110,0", spline, false, 7, {10, 0}, 5 * pi},
                             {"M10 0A10 10 0 0 1 0 10", spline, false, 4, {0, 10}, 5 * pi},
                             {"M10 0A10 10 0 1 0 0 10", spline, false, 10, {0, 10}, 15 * pi},
                             {"M0 0A1 1 0 0 1 10 0", spline, false, 7, {10, 0}, 5 * pi},
                             {"M0 0A-5 5 90 0 1 10 0", spline, false, 7, {10, 0}, 5 * pi},
                             {"M0 0A0 5 0 0 1 3 4", polygon, false, 2, {3, 4}, 5},
                             {"M0 0a1 1 0 001 1", spline, false, 4, {1, 1}, pi / 2},
                             {"M0 0A1e300 1e300 0 0 1 3 4", spline, false, 4, {3, 4}, 5},
                             {"M0 0A1e7 1e7 0 0 1 3 4", spline, false, 4, {3, 4}, 5},
                             {"M8 0a8 8 0 1 1 0 16A8 8 0 0 1 8 0z",
                              spline,
                              true,
                              12,
                              {8 - 32.0 / 3 * (std::numbers::sqrt2 - 1), 0},
                              16 * pi},
                             {"M0 0A3 4 0 0 0 3 4L0 0", spline, false, 7, {0, 0}, 10.525}}));

TEST(SvgPath, anotherSubpathBeginsAfterEveryMoveAndClosing) {
    const auto curves = drawn("M0 0h4v4zM9 9h1l2 2zl1 1m5 5c1 1 2 2 3 3");
    ASSERT_EQ(curves.size(), 4u);
    EXPECT_TRUE(curves[0].closed);
    EXPECT_TRUE(curves[1].closed);
    EXPECT_EQ(curves[2].points, (Points{{9, 9}, {10, 10}})) << "from the start of the closed one";
    EXPECT_EQ(curves[3].points.at(0), Point({15, 15}));
    EXPECT_EQ(curves[3].family, "bezier-spline");
    EXPECT_TRUE(drawn("").empty());
    EXPECT_TRUE(drawn("M5 5").empty());
    EXPECT_TRUE(drawn("M5 5zm1 1z").empty());
}

TEST(SvgPath, closingAddsTheStraightPieceThatIsMissing) {
    const Curve open = drawnAlone("M0 0C0 3 6 3 6 0Z");
    EXPECT_TRUE(open.closed);
    EXPECT_EQ(open.points, (Points{{0, 0}, {0, 3}, {6, 3}, {6, 0}, {4, 0}, {2, 0}}));
    const Curve back = drawnAlone("M0 0C0 3 6 3 6 0C6-3 0-3 1e-9 0Z");
    EXPECT_EQ(back.points.size(), 6u) << "the rounding of relative coordinates";
    EXPECT_FALSE(drawnAlone("M1 1L3 1Z").closed && drawnAlone("M1 1h0z").closed);
}

TEST(SvgPath, arcsLieOnTheirEllipses) {
    // A tilted ellipse: every place of the curve, turned back, is on it.
    const Curve curve = drawnAlone("M20 10A30 10 30 1 1 25 5");
    const Pieces pieces = piecesOf(curve);
    const auto box = bounds(pieces);
    const Point center = 0.5 * (box->low + box->high);
    EXPECT_GT(pieces.size(), 2u);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (const double u : {0.0, 0.25, 0.6, 1.0}) {
            const Point from = pieces.position({i, u}) - center;
            const double c = std::cos(pi / 6), s = std::sin(pi / 6);
            const double x = (c * from[0] + s * from[1]) / 30;
            const double y = (-s * from[0] + c * from[1]) / 10;
            EXPECT_NEAR(std::hypot(x, y), 1, 0.02) << i << ' ' << u;
        }
    }
    const Pieces quarter = piecesOf(drawnAlone("M100 0A100 100 0 0 1 0 100"));
    for (const double u : {0.1, 0.21, 0.5, 0.8}) {
        EXPECT_NEAR(norm(quarter.position({0, u})), 100, 0.03);
    }
}

struct BadPath {
    std::string data, place, what, remedy;
};

TEST(SvgPath, refusesWithThePlaceAndWhatWouldBeRight) {
    for (const auto& [data, place, what, remedy] :
         std::vector<BadPath>{{"L1 2", "byte 0", "\"L\"", "M or m"},
                              {"M1", "byte 2", "the data end", "a number"},
                              {"M1 2 3", "byte 6", "the data end", "a number"},
                              {"M1 2L3 x", "byte 7", "no number", "a number"},
                              {"M1 2 B3 4", "byte 5", "\"B\"", "M L H V"},
                              {"M1 2 # 3", "byte 5", "\"#\"", "M L H V"},
                              {"M1,,2", "byte 3", "no number", "a number"},
                              {"M1 2C1 2 3 4 5", "byte 14", "the data end", "a number"},
                              {"M0 0A5 5 0 2 1 10 0", "byte 11", "flag", "0 or 1"},
                              {"M0 0A5 5 0 0", "byte 12", "flag", "0 or 1"},
                              {"M1 1e999", "byte 3", "no number", "a number"},
                              {"M nan nan", "byte 2", "no number", "a number"},
                              {"M- 1 2", "byte 1", "no number", "a number"},
                              {"M1 2Z3 4", "byte 5", "\"3\"", "M L H V"}}) {
        const auto curves = curvesFromPathData(data);
        ASSERT_FALSE(curves) << data;
        EXPECT_EQ(curves.refusal().place, place) << data << ": " << curves.refusal().message();
        EXPECT_NE(curves.refusal().what.find(what), std::string::npos)
            << curves.refusal().message();
        EXPECT_NE(curves.refusal().remedy.find(remedy), std::string::npos)
            << curves.refusal().message();
    }
}

} // namespace
} // namespace splineloft
