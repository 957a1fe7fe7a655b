// Curves to edit, beside one that must be left alone.
#pragma once

#include "core/document/document.h"
#include "core/spline/catalog.h"
#include "tests/documents.h"
#include "tests/property/random_curves.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace splineloft::testing_curves {

inline Curve planeCurve(const std::string& family, std::size_t count, bool closed = false) {
    Dice dice(count + 31);
    Curve curve = emptyCurve({family, closed, formsOf(family).front().ends}, 2);
    rollPoints(curve, count, {200, -70}, 20, dice);
    return curve;
}

/// Two curves: the one given, and a bystander that no edit may touch.
inline Document besideBystander(Curve curve) {
    Document document;
    document.curves = {std::make_shared<Curve>(std::move(curve)),
                       std::make_shared<Curve>(planeCurve("natural", 5))};
    return document;
}

inline void expectPlausible(const Document& before, const Document& after,
                            const std::string& what) {
    const auto problem = problemOf(after);
    EXPECT_FALSE(problem) << what << ": " << problem->place << ' ' << problem->what;
    ASSERT_FALSE(after.curves.empty()) << what;
    EXPECT_EQ(after.curves.back(), before.curves.back()) << what << " shares the other curve";
}

/// Anchors at 0, 3, 6; the handles 2 and 4 are in line with anchor 3, and 4 is twice as far.
inline Curve smoothBezierSpline() {
    Curve curve = emptyCurve({"bezier-spline", false, Ends::none}, 2);
    curve.points = {{100, 50}, {103, 50}, {110, 56}, {113, 60}, {119, 68}, {125, 60}, {126, 50}};
    return curve;
}

} // namespace splineloft::testing_curves
