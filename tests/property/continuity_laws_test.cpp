// How smoothly the families join their pieces, as the textbooks say: by derivatives computed here
// from the Bézier points, and by what `jointsOf` measures.
#include "tests/property/random_curves.h"

#include "core/spline/continuity.h"

#include <cmath>
#include <limits>

namespace splineloft::testing_curves {
namespace {

class Continuity : public EveryFamily {};

/// Difference number `order` of the Bézier points at one end of a piece: its derivative of that
/// order there, but for the factor degree! / (degree - order)!.
Point endDifference(const Piece& piece, int order, bool atEnd) {
    Point sum(piece.dimension);
    double binomial = 1;
    for (int k = 0; k <= order; ++k) {
        const double sign = (order - k) % 2 == 0 ? 1 : -1;
        sum += (sign * binomial) * piece.bezierPoint((atEnd ? piece.degree - order : 0) + k);
        binomial = binomial * (order - k) / (k + 1);
    }
    return sum;
}

/// One joint of a curve with the derivatives by t on both sides.
struct BothSides {
    Jet before, after;
    double hBefore = 1, hAfter = 1; ///< intervals of the two pieces
};

template <class Check> void forEachJoint(const Curve& curve, Check check) {
    const Pieces pieces = piecesOf(curve);
    const auto n = pieces.size();
    for (std::size_t i = 1; i < n + (curve.closed ? 1 : 0); ++i) {
        SCOPED_TRACE("joint " + std::to_string(i));
        check(BothSides{pieces.jetByParameter({i - 1, 1}), pieces.jetByParameter({i % n, 0}),
                        pieces.knots().interval(i - 1), pieces.knots().interval(i % n)});
    }
}

/// What rounding may leave of two equal first (second) derivatives by t: each is degree (times
/// degree - 1) differences of two (four) Bézier points over the interval (squared).
struct Slack {
    explicit Slack(const Curve& curve) : position(roundingOf(curve, blendsOf(curve))) {}
    double position;
    double first(const BothSides& s) const {
        return 3 * 2 * position * (1 / s.hBefore + 1 / s.hAfter);
    }
    double second(const BothSides& s) const {
        return 6 * 4 * position * (std::pow(s.hBefore, -2) + std::pow(s.hAfter, -2));
    }
};

TEST_P(Continuity, piecesMeet) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        const Slack slack(curve);
        forEachJoint(curve, [&](const BothSides& s) {
            expectNear(s.before.position, s.after.position, 2 * slack.position, "position");
        });
    });
}

/// The curve is C1 by t.
void expectC1(const Curve& curve) {
    const Slack slack(curve);
    forEachJoint(curve, [&](const BothSides& s) {
        expectNear(s.before.first, s.after.first, slack.first(s), "first");
    });
}

void expectC2(const Curve& curve) {
    expectC1(curve);
    const Slack slack(curve);
    forEachJoint(curve, [&](const BothSides& s) {
        expectNear(s.before.second, s.after.second, slack.second(s), "second");
    });
}

TEST(ContinuityOf, bSplinesOfDegreeDIsAllDerivativesBelowD) {
    forEveryForm("b-spline", 4 * usualRounds, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const auto n = pieces.size();
        double rounding = roundingOf(curve, blendsOf(curve));
        for (int order = 0; order < pieces.degree(); ++order, rounding *= 2) {
            for (std::size_t i = 1; i < n + (curve.closed ? 1 : 0); ++i) {
                // By t, in units of the longer interval.
                const double before = pieces.knots().interval(i - 1);
                const double after = pieces.knots().interval(i % n);
                const double unit = std::max(before, after);
                const double shrink = std::pow(unit / std::min(before, after), order);
                expectNear(
                    std::pow(unit / before, order) * endDifference(pieces[i - 1], order, true),
                    std::pow(unit / after, order) * endDifference(pieces[i % n], order, false),
                    2 * shrink * rounding,
                    "order " + std::to_string(order) + " joint " + std::to_string(i));
            }
        }
    });
}

TEST(ContinuityOf, bSplinesOfDegreeDBreaksInDerivativeD) {
    for (int degree = 1; degree <= 7; ++degree) {
        Dice dice(static_cast<std::uint64_t>(degree));
        Curve curve = emptyCurve({"b-spline", false, Ends::open}, 2);
        curve.parameters["degree"] = degree;
        rollPoints(curve, static_cast<std::size_t>(degree) + 2, {30, -50}, 8, dice);
        const Pieces pieces = piecesOf(curve);
        EXPECT_GT(distance(endDifference(pieces[0], degree, true),
                           endDifference(pieces[1], degree, false)),
                  0.01)
            << "degree " << degree;
    }
}

TEST(ContinuityOf, tangentFamiliesIsC1) {
    for (const auto* family : {"cardinal", "catmull-rom", "hermite"}) {
        forEveryForm(family, usualRounds, expectC1);
    }
}

TEST(ContinuityOf, naturalIsC2) {
    forEveryForm("natural", 4 * usualRounds, expectC2);
}

TEST(ContinuityOf, naturalHasNoSecondDerivativeAtItsFreeEnds) {
    forEveryForm("natural", 4 * usualRounds, [](const Curve& curve) {
        if (curve.closed) {
            return;
        }
        const Slack slack(curve);
        const Pieces pieces = piecesOf(curve);
        const auto last = pieces.size() - 1;
        for (const Spot end : {Spot{0, 0}, Spot{last, 1}}) {
            const double h = pieces.knots().interval(end.segment);
            expectNear(pieces.jetByParameter(end).second, Point(pieces.dimension()),
                       6 * 4 * slack.position / (h * h), "second at an end");
        }
    });
}

TEST(ContinuityOf, duffIsC1AndG2ButNotC2) {
    forEveryForm("duff", usualRounds, [](const Curve& curve) {
        expectC1(curve);
        // Its second derivative jumps along the tangent by the tension of the beta-spline that it
        // is.
        const double a = curve.parameters.at("tension");
        const double tension = a > 0 ? 12 * (1 - a) / a : 0;
        if (a < 1e-3) {
            return;
        }
        const Slack slack(curve);
        forEachJoint(curve, [&](const BothSides& s) {
            expectNear(s.after.second - s.before.second, tension * s.before.first,
                       slack.second(s) + tension * slack.first(s), "jump of the second");
        });
    });
}

TEST(ContinuityOf, betaJumpsAsBarskySays) {
    forEveryForm("beta", 4 * usualRounds, [](const Curve& curve) {
        const double b1 = curve.parameters.at("bias");
        const double b2 = curve.parameters.at("tension");
        const Slack slack(curve);
        forEachJoint(curve, [&](const BothSides& s) {
            const double first = (1 + b1) * slack.first(s);
            expectNear(s.after.first, b1 * s.before.first, first, "P'+ = b1 P'-");
            expectNear(s.after.second, b1 * b1 * s.before.second + b2 * s.before.first,
                       (1 + b1 * b1) * slack.second(s) + b2 * slack.first(s),
                       "P''+ = b1^2 P''- + b2 P'-");
        });
    });
}

/// What the badges should say of a family, at a joint of a curve through scattered points.
struct Verdict {
    std::string family;
    std::map<std::string, double> parameters;
    int c, g;
};

const std::vector<Verdict> verdicts = {
    {"linear", {}, 0, 0},
    {"hermite", {}, 1, 1},
    {"cardinal", {{"tension", 0.5}}, 1, 1},
    {"cardinal", {{"tension", 1.3}}, 1, 1},
    {"catmull-rom", {{"alpha", 0}}, 1, 1},
    {"catmull-rom", {{"alpha", 0.5}}, 1, 1},
    {"catmull-rom", {{"alpha", 1}}, 1, 1},
    {"natural", {{"alpha", 0}}, 2, 2},
    {"natural", {{"alpha", 1}}, 2, 2},
    {"b-spline", {{"degree", 1}}, 0, 0},
    {"b-spline", {{"degree", 2}}, 1, 1},
    {"b-spline", {{"degree", 3}}, 2, 2},
    {"b-spline", {{"degree", 5}}, 2, 2},
    {"duff", {{"tension", 1}}, 2, 2},
    {"duff", {{"tension", 0.4}}, 1, 2},
    {"beta", {{"bias", 1}, {"tension", 0}}, 2, 2},
    {"beta", {{"bias", 1}, {"tension", 7}}, 1, 2},
    {"beta", {{"bias", 3}, {"tension", 0}}, 0, 2},
    {"beta", {{"bias", 0.3}, {"tension", 7}}, 0, 2},
};

/// Calls `check(verdict, joint, where)` for every joint of scattered points around (center,
/// -center).
template <class Check> void forEachVerdict(double center, double extent, Check check) {
    for (const auto& verdict : verdicts) {
        for (const auto& form : formsOf(verdict.family)) {
            Dice dice(static_cast<std::uint64_t>(center + extent));
            Curve curve = emptyCurve(form, 2);
            curve.parameters = verdict.parameters;
            rollPoints(curve, 9, {center, -center}, extent, dice);
            for (const auto& joint : jointsOf(piecesOf(curve), curve.closed)) {
                check(verdict, joint,
                      wordsOf(curve) + " center " + std::to_string(center) + " extent " +
                          std::to_string(extent) + " t " + std::to_string(joint.t) + ": " +
                          describe(joint));
            }
        }
    }
}

/// The same verdict near the origin and far from it, on small curves and on large ones.
TEST(ContinuityOf, familiesIsMeasuredAsTheTextbooksSay) {
    for (const double center : {0.0, 1e3, 1e6}) {
        for (const double extent : {1.0, 300.0}) {
            forEachVerdict(
                center, extent,
                [](const Verdict& verdict, const Joint& joint, const std::string& where) {
                    EXPECT_EQ(joint.c, verdict.c) << where;
                    EXPECT_EQ(joint.g, verdict.g) << where;
                });
        }
    }
}

/// So far out that only 23 bits are left for the shape, smooth joints must not be called rough.
TEST(ContinuityOf, familiesSurvivesTheFarthestCoordinates) {
    forEachVerdict(1e9, 1,
                   [](const Verdict& verdict, const Joint& joint, const std::string& where) {
                       EXPECT_GE(joint.c, verdict.c) << where;
                       EXPECT_GE(joint.g, verdict.g) << where;
                   });
}

TEST(ContinuityOf, betaHasTheSpeedRatioOfItsBias) {
    for (const double bias : {0.25, 1.0, 3.0}) {
        Dice dice(4);
        Curve curve = emptyCurve({"beta", true, Ends::doubled}, 3);
        curve.parameters = {{"bias", bias}, {"tension", 2}};
        rollPoints(curve, 7, {40, -30, 100}, 9, dice);
        for (const auto& joint : jointsOf(piecesOf(curve), true)) {
            EXPECT_NEAR(joint.speedRatio, bias, 1e-12 * bias) << joint.t;
        }
    }
}

/// Continuity by the parameter of a moving curve is continuity of its shape.
TEST_P(Continuity, whatIsSmoothByParameterIsSmoothInShape) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        for (const auto& joint : jointsOf(pieces, curve.closed)) {
            const bool moving = norm(pieces.jet({joint.before, 1}).first) > 1e-6 &&
                                norm(pieces.jet({joint.after, 0}).first) > 1e-6;
            if (moving) {
                EXPECT_GE(joint.g, joint.c) << "t " << joint.t << ": " << describe(joint);
            }
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Families, Continuity, testing::ValuesIn(familyIds()), testNameOf);

} // namespace
} // namespace splineloft::testing_curves
