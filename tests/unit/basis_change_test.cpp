// Matrices against the sources' pages and against what the families really draw.
#include "core/spline/change/basis_change.h"

#include "tests/property/random_curves.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace splineloft {
namespace {

using namespace testing_curves;

RationalMatrix matrixIn(const MatrixOrProblem& result) {
    if (const auto* problem = std::get_if<Problem>(&result)) {
        ADD_FAILURE() << problem->what << "; " << problem->remedy;
        return RationalMatrix(4);
    }
    return std::get<RationalMatrix>(result);
}

RationalMatrix over(std::int64_t denominator, const std::vector<std::int64_t>& numerators) {
    std::vector<Rational> entries;
    for (const auto numerator : numerators) {
        entries.emplace_back(numerator, denominator);
    }
    return {4, entries};
}

RationalMatrix unit() {
    return over(1, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
}

/// Each basis with parameters that none of its formulas hide.
std::vector<CubicBasis> someBases() {
    return {{"power", {}},
            {"bezier", {}},
            {"hermite", {}},
            {"cardinal", {{3, 7}}},
            {"catmull-rom", {}},
            {"b-spline", {}},
            {"duff", {{2, 5}}},
            {"beta", {{3, 2}, {5, 7}}},
            {"bc-spline", {{1, 3}, {2, 7}}},
            {"kochanek-bartels", {{1, 3}, {-2, 5}, {1, 7}}}};
}

TEST(Rational, arithmeticIsExactAndReduced) {
    EXPECT_EQ(Rational(6, -8), Rational(-3, 4));
    EXPECT_EQ(Rational(1, 3) + Rational(1, 6), Rational(1, 2));
    EXPECT_EQ(Rational(5, 7) - Rational(5, 7), Rational(0));
    EXPECT_EQ(Rational(5, 7) / Rational(-10, 21), Rational(-3, 2));
    EXPECT_EQ(textOf(Rational(-3, 4)), "-3/4");
    EXPECT_EQ(textOf(Rational(10, 5)), "2");
    const std::int64_t most = std::numeric_limits<std::int64_t>::max();
    EXPECT_EQ(Rational(most) / Rational(most), Rational(1));
    EXPECT_EQ(Rational(1, most) * Rational(most, 3), Rational(1, 3));
    EXPECT_THROW(Rational(most) + Rational(1), std::overflow_error);
    EXPECT_THROW(Rational(1, most) * Rational(1, 2), std::overflow_error);
    EXPECT_THROW(Rational(1, 0), std::domain_error);
    EXPECT_THROW(Rational(1) / Rational(0), std::domain_error);
    EXPECT_THROW(Rational(std::numeric_limits<std::int64_t>::min(), 1), std::overflow_error);
}

TEST(BasisChange, ofTheMemoAndTheLecture) {
    // Smith 1983: C_a = M1^-1 M2, where M2 makes tangents of points.
    const auto cardinal = matrixIn(powerMatrix({"cardinal", {{2, 3}}}));
    const RationalMatrix m2 = over(3, {0, 3, 0, 0, 0, 0, 3, 0, -2, 0, 2, 0, 0, -2, 0, 2});
    EXPECT_EQ(matrixIn(powerMatrix({"hermite", {}})) * m2, cardinal);
    EXPECT_EQ(matrixIn(basisChange({"cardinal", {{2, 3}}}, {"hermite", {}})), m2);
    // M1 itself.
    EXPECT_EQ(matrixIn(basisChange({"power", {}}, {"hermite", {}})),
              over(1, {0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 1, 0, 3, 2, 1, 0}));
    // The lecture, equation 7, has rows from 1 to u^3 and the tangent after each point.
    const int lecture[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {-3, -2, 3, -1}, {2, 1, -2, 1}};
    const auto hermite = matrixIn(powerMatrix({"hermite", {}}));
    const int column[] = {0, 2, 1, 3};
    for (int row = 0; row < 4; ++row) {
        for (int k = 0; k < 4; ++k) {
            EXPECT_EQ(hermite.at(3 - row, column[k]), Rational(lecture[row][k])) << row << k;
        }
    }
}

TEST(BasisChange, knownOnes) {
    EXPECT_EQ(matrixIn(basisChange({"b-spline", {}}, {"bezier", {}})),
              over(6, {1, 4, 1, 0, 0, 4, 2, 0, 0, 2, 4, 0, 0, 1, 4, 1}));
    EXPECT_EQ(matrixIn(basisChange({"bezier", {}}, {"b-spline", {}})),
              over(1, {6, -7, 2, 0, 0, 2, -1, 0, 0, -1, 2, 0, 0, 2, -7, 6}));
    EXPECT_EQ(matrixIn(basisChange({"catmull-rom", {}}, {"bezier", {}})),
              over(6, {0, 6, 0, 0, -1, 6, 1, 0, 0, 1, 6, -1, 0, 0, 6, 0}));
    EXPECT_EQ(matrixIn(basisChange({"hermite", {}}, {"bezier", {}})),
              over(3, {3, 0, 0, 0, 3, 0, 1, 0, 0, 3, 0, -1, 0, 3, 0, 0}));
    EXPECT_EQ(matrixIn(basisChange({"cardinal", {{1, 2}}}, {"catmull-rom", {}})), unit());
    EXPECT_EQ(matrixIn(basisChange({"duff", {1}}, {"b-spline", {}})), unit());
    EXPECT_EQ(matrixIn(basisChange({"beta", {1, 0}}, {"b-spline", {}})), unit());
    // Smith 1983: Duff's a is Barsky's beta2 = 12 (1 - a) / a; here a = 2/5.
    EXPECT_EQ(matrixIn(basisChange({"duff", {{2, 5}}}, {"beta", {1, 18}})), unit());
    EXPECT_EQ(matrixIn(basisChange({"bc-spline", {{2, 5}, 0}}, {"duff", {{2, 5}}})), unit());
    EXPECT_EQ(matrixIn(basisChange({"kochanek-bartels", {0, 0, 0}}, {"catmull-rom", {}})), unit());
}

TEST(BasisChange, thereAndBackIsNothing) {
    for (const auto& from : someBases()) {
        for (const auto& to : someBases()) {
            const auto there = matrixIn(basisChange(from, to));
            const auto back = matrixIn(basisChange(to, from));
            EXPECT_EQ(back * there, unit()) << from.id << " to " << to.id;
            EXPECT_EQ(matrixIn(powerMatrix(to)) * there, matrixIn(powerMatrix(from)));
        }
    }
}

TEST(BasisChange, bezierPointsAreThoseThatTheFamilyDraws) {
    for (const auto& basis : someBases()) {
        const std::string id(basis.id);
        if (id == "power" || id == "bezier") {
            continue;
        }
        const bool isHermite = id == "hermite";
        Curve curve = emptyCurve({id, false, isHermite ? Ends::none : Ends::open}, 1);
        curve.points = {{3}, {5}, {4}, {9}};
        if (isHermite) {
            curve.points = {{3}, {5}};
            curve.tangents = {{-2}, {7}};
        }
        if (id == "catmull-rom") {
            curve.parameters["alpha"] = 0;
        }
        for (std::size_t i = 0; i < basis.parameters.size(); ++i) {
            const std::string key(familyOf(curve).parameters[i].key);
            curve.parameters[key] = basis.parameters[i].value();
        }
        const BlendPieces blends = blendsOf(curve);
        ASSERT_EQ(blends.size(), 1u) << id;
        const auto matrix = matrixIn(basisChange(basis, {"bezier", {}}));
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 4; ++column) {
                const Blend& blend = blends[0][static_cast<std::size_t>(row)];
                EXPECT_NEAR(blend.weight(static_cast<std::size_t>(column)),
                            matrix.at(row, column).value(), 1e-15)
                    << id << ", Bézier point " << row << ", control " << column;
            }
        }
    }
}

std::string problemIn(const MatrixOrProblem& result) {
    const auto* problem = std::get_if<Problem>(&result);
    return problem != nullptr ? problem->what : "no problem";
}

TEST(BasisChange, refusals) {
    const CubicBasis bezier{"bezier", {}};
    for (const CubicBasis& flat :
         {CubicBasis{"cardinal", {0}}, CubicBasis{"duff", {0}}, CubicBasis{"bc-spline", {0, 0}},
          CubicBasis{"kochanek-bartels", {1, 0, 0}}, CubicBasis{"beta", {0, 1}}}) {
        EXPECT_NE(problemIn(basisChange(bezier, flat)).find("every cubic"), std::string::npos)
            << flat.id;
        EXPECT_EQ(problemIn(basisChange(flat, bezier)), "no problem") << flat.id;
    }
    EXPECT_EQ(problemIn(powerMatrix({"beta", {1, -12}})), "the matrix has a denominator of 0");
    EXPECT_EQ(problemIn(powerMatrix({"natural", {}})), "there is no matrix for \"natural\"");
    EXPECT_EQ(problemIn(powerMatrix({"cardinal", {}})), "0 numbers are given");
    const Rational huge(std::int64_t{1} << 40, 3);
    EXPECT_EQ(problemIn(powerMatrix({"beta", {huge, huge}})), "needs numbers of more than 64 bits");
}

TEST(BasisChange, powerAndBezierOfEveryDegree) {
    for (int degree = 0; degree <= 30; ++degree) {
        const auto down = matrixIn(bezierToPower(degree));
        const auto up = matrixIn(powerToBezier(degree));
        RationalMatrix identity(degree + 1);
        for (int i = 0; i <= degree; ++i) {
            identity.at(i, i) = 1;
        }
        EXPECT_EQ(up * down, identity) << degree;
    }
    EXPECT_EQ(matrixIn(bezierToPower(3)), matrixIn(powerMatrix({"bezier", {}})));
    EXPECT_EQ(problemIn(bezierToPower(-1)), "is -1");
    EXPECT_EQ(problemIn(bezierToPower(100)), "needs numbers of more than 64 bits");
    EXPECT_EQ(problemIn(powerToBezier(100)), "needs numbers of more than 64 bits");
}

TEST(BasisChange, printedAsInTheMemo) {
    EXPECT_EQ(textOf(matrixIn(powerMatrix({"catmull-rom", {}}))), "1/2 [ -1  3 -3  1 ]\n"
                                                                  "    [  2 -5  4 -1 ]\n"
                                                                  "    [ -1  0  1  0 ]\n"
                                                                  "    [  0  2  0  0 ]\n");
}

} // namespace
} // namespace splineloft
