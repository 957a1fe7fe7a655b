// de Boor, Barry and Goldman, Neville: the tip is the point of the curve, and every rung lies on
// the line that it says it lies on.
#include "core/spline/change/constructions.h"
#include "tests/property/random_curves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splineloft {
namespace {

using namespace testing_curves;

const Construction& valueOf(const std::variant<Construction, Problem>& result) {
    if (const auto* problem = std::get_if<Problem>(&result)) {
        throw std::runtime_error(problem->what);
    }
    return std::get<Construction>(result);
}

/// Each level has one rung fewer, and each rung is where its interval says that t is.
void expectConsistent(const Construction& construction, double t, double tolerance) {
    const auto& levels = construction.levels;
    for (std::size_t r = 1; r < levels.size(); ++r) {
        ASSERT_EQ(levels[r].size() + 1, levels[r - 1].size());
        for (std::size_t i = 0; i < levels[r].size(); ++i) {
            const Rung& rung = levels[r][i];
            EXPECT_LE(rung.from, rung.to);
            if (rung.to > rung.from) {
                const double share = (t - rung.from) / (rung.to - rung.from);
                const Point wanted =
                    lerp(levels[r - 1][i].place, levels[r - 1][i + 1].place, share);
                expectNear(rung.place, wanted, tolerance * (1 + std::abs(share)),
                           "level " + std::to_string(r) + ", rung " + std::to_string(i));
            }
        }
    }
    EXPECT_EQ(levels.back().size(), 1U);
}

TEST(DeBoor, tipIsThePointOfTheCurve) {
    for (const std::string family : {"b-spline", "nurbs"}) {
        forEveryForm(family, 300, [&](Curve curve) {
            Dice dice(curve.points.size());
            for (std::size_t i = 0; i < curve.points.size() && family == "nurbs"; ++i) {
                curve.weights.push_back(std::exp2(dice.between(-3, 3)));
            }
            const Pieces pieces = piecesOf(curve);
            const double tolerance = 512 * roundingOf(curve, blendsOf(curve));
            for (int k = 0; k <= 6; ++k) {
                const double t = lerp(pieces.knots().start(), pieces.knots().end(), k / 6.0);
                const auto construction = valueOf(deBoor(curve, t));
                expectNear(construction.tip(), pieces.position(pieces.knots().locate(t)), tolerance,
                           "tip");
                EXPECT_EQ(construction.levels.size(),
                          static_cast<std::size_t>(pieces.degree()) + 1);
                if (family == "b-spline") {
                    expectConsistent(construction, t, tolerance);
                }
            }
        });
    }
}

TEST(DeBoor, movesTheParameterIntoTheCurve) {
    Curve curve;
    curve.family = "b-spline";
    curve.points = {{11, 2}, {13, 7}, {17, 5}, {19, 9}};
    const Pieces pieces = piecesOf(curve);
    for (const double t : {-1e300, -1.0, 1e300, double(INFINITY), double(NAN)}) {
        const Point end = pieces.position(pieces.knots().locate(t));
        expectNear(valueOf(deBoor(curve, t)).tip(), end, 1e-13, std::to_string(t));
    }
}

TEST(BarryGoldman, tipIsThePointOfTheCurve) {
    forEveryForm("catmull-rom", 1000, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const double tolerance = 64 * roundingOf(curve, blendsOf(curve));
        Dice dice(curve.points.size());
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            for (const double u : {0.0, 1.0, dice.between(0, 1)}) {
                const auto construction = valueOf(barryGoldman(curve, {i, u}));
                expectNear(construction.tip(), pieces.position({i, u}), tolerance, "tip");
                ASSERT_EQ(construction.levels.size(), 4U);
                EXPECT_EQ(construction.levels[3][0].from, pieces.knots().knots()[i]);
                EXPECT_EQ(construction.levels[3][0].to, pieces.knots().knots()[i + 1]);
                const double t = pieces.knots().parameter({i, u});
                expectConsistent(construction, t, 4 * tolerance);
            }
        }
    });
}

TEST(BarryGoldman, coincidentPointsRest) {
    Curve curve;
    curve.family = "catmull-rom";
    curve.ends = Ends::open;
    for (const double alpha : {0.0, 0.25, 0.5, 1.0}) {
        curve.parameters["alpha"] = alpha;
        for (int same = 0; same < 64; ++same) { // which neighbours coincide
            curve.points = Points(2);
            for (int i = 0; i <= 6; ++i) {
                const bool stays = i > 0 && (same >> (i - 1)) % 2 == 1;
                curve.points.append(stays ? curve.points.at(curve.points.size() - 1)
                                          : Point{11.0 + i * i, 7.0 - 3 * i});
            }
            const Pieces pieces = piecesOf(curve);
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                for (const double u : {0.0, 0.3, 1.0}) {
                    const auto construction = valueOf(barryGoldman(curve, {i, u}));
                    for (const auto& level : construction.levels) {
                        for (const auto& rung : level) {
                            EXPECT_TRUE(std::isfinite(norm(rung.place)));
                        }
                    }
                    expectNear(construction.tip(), pieces.position({i, u}), 1e-12,
                               "alpha " + std::to_string(alpha) + ", same " + std::to_string(same) +
                                   ", segment " + std::to_string(i) + ", u " + std::to_string(u));
                }
            }
        }
    }
}

TEST(Neville, tipIsThePointOfTheCurve) {
    forEveryForm("lagrange", 300, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const double tolerance = 64 * roundingOf(curve, blendsOf(curve));
        for (int k = 0; k <= 10; ++k) {
            const double u = k / 10.0;
            const auto construction = valueOf(neville(curve, u));
            expectNear(construction.tip(), pieces.position({0, u}), tolerance, "tip");
            expectConsistent(construction, u, tolerance);
        }
    });
}

TEST(Constructions, refuseOtherFamiliesByName) {
    Curve curve;
    curve.points = {{11, 2}, {13, 7}, {17, 5}, {19, 9}};
    for (const auto& result : {deBoor(curve, 0), barryGoldman(curve, {}), neville(curve, 0)}) {
        ASSERT_TRUE(std::holds_alternative<Problem>(result));
        EXPECT_NE(std::get<Problem>(result).what.find("cardinal"), std::string::npos);
        EXPECT_FALSE(std::get<Problem>(result).remedy.empty());
    }
    curve.family = "b-spline";
    curve.points = {{11, 2}};
    EXPECT_TRUE(std::holds_alternative<Problem>(deBoor(curve, 0)));
    curve.points = Points(2);
    EXPECT_TRUE(std::holds_alternative<Problem>(deBoor(curve, 0)));
}

} // namespace
} // namespace splineloft
