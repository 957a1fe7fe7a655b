// Plots of speed, acceleration and curvature, worked with real events, and what they show.
#include "driver.h"
#include "hand.h"

#include "ui/canvas/motion_plot.h"
#include "ui/canvas/ticks.h"
#include "ui/commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

constexpr std::array motions = {Plot::speed, Plot::acceleration, Plot::curvature};

Document plain() {
    return documentOf({curveOf("cardinal")});
}

Curve bezierOf(Points points) {
    Curve curve;
    curve.family = "bezier";
    curve.ends = Ends::none;
    curve.coordinates.clear();
    curve.points = std::move(points);
    for (int i = 0; i < curve.points.dimension(); ++i) {
        curve.coordinates.push_back("c" + std::to_string(i));
    }
    return curve;
}

/// The heights of the graph's vertices in the last frame.
std::vector<double> heights(const Driver& driver) {
    const Colour colour = colourOf(themeOf(driver.session.view.theme), {Role::motion});
    std::vector<double> y;
    for (const auto& vertex : driver.result.pictures.back().ribbons) {
        if (vertex.colour == colour) {
            y.push_back(double(vertex.y));
        }
    }
    return y;
}

double spreadOf(const std::vector<double>& values) {
    return values.empty() ? 0 : std::ranges::max(values) - std::ranges::min(values);
}

TEST(MotionPlot, isChosenByAClick) {
    Driver driver(plain());
    for (std::size_t i = 1; i < plotNames.size(); ++i) {
        driver.click(Widget{"strip", {"plot", std::string(plotNames[i])}});
        EXPECT_EQ(driver.session.view.plot, static_cast<Plot>(i));
        EXPECT_GT(heights(driver).size(), 100U) << plotNames[i] << " is drawn";
        EXPECT_FALSE(driver.has(Widget{"strip", {"segments"}}));
    }
    driver.click(Widget{"strip", {"plot", "basis"}});
    EXPECT_EQ(driver.session.view.plot, Plot::basis);
    EXPECT_TRUE(driver.has(Widget{"strip", {"segments"}}));
    EXPECT_EQ(driver.steps(), 0) << "how one looks is no edit";
}

TEST(MotionPlot, isChosenFromAListWhereTheStripIsNarrow) {
    Driver driver(plain(), {800, 600, 1});
    driver.click(Widget{"strip", {"##plot"}});
    driver.click(driver.option("curvature"));
    EXPECT_EQ(driver.session.view.plot, Plot::curvature);
    EXPECT_FALSE(heights(driver).empty());
}

TEST(MotionPlot, isChosenByACommandWhateverIsShown) {
    Driver driver(plain());
    for (const auto& [key, plot] : {std::pair{Key::s, Plot::speed},
                                    {Key::a, Plot::acceleration},
                                    {Key::k, Plot::curvature},
                                    {Key::h, Plot::basis}}) {
        driver.session.view.layers.basis = false;
        driver.session.view.log = true;
        driver.frames(1);
        driver.key(key, withShift);
        EXPECT_EQ(driver.session.view.plot, plot);
        EXPECT_TRUE(driver.session.view.layers.basis);
        EXPECT_FALSE(driver.session.view.log) << "it would stand in its place";
        for (std::size_t i = 0; i < plotNames.size(); ++i) {
            EXPECT_EQ(commandNamed("plot." + std::string(plotNames[i])).checked(driver.session),
                      plot == static_cast<Plot>(i));
        }
    }
}

TEST(MotionPlot, aDragMovesTheCursorInTime) {
    Driver driver(plain());
    for (const auto pace : {Even::length, Even::parameter}) {
        for (const auto plot : motions) {
            driver.session.view.pace = pace;
            driver.session.view.plot = plot;
            driver.session.view.playing = true;
            driver.frames(1, 0);
            const auto rect = *driver.find(Widget{"strip", {"whole"}});
            const auto timeNow = [&] {
                const auto& view = driver.session.view;
                return driver.session.active()->motion(pace, view.duration).timeAt(view.cursor);
            };
            const double y = rect.top + rect.height / 2;
            driver.press({rect.left + 0.25 * rect.width, y});
            EXPECT_FALSE(driver.session.view.playing);
            const double first = timeNow();
            EXPECT_NEAR(first, 0.25 * driver.session.view.duration, 0.02);
            driver.move({rect.left + 0.8 * rect.width, y});
            EXPECT_NEAR(timeNow(), 0.8 * driver.session.view.duration, 0.02);
            driver.move({rect.right() + 500, rect.top});
            EXPECT_EQ(driver.session.view.cursor.u, 1) << "held at the end";
            driver.move({rect.left - 500, rect.top});
            EXPECT_EQ(timeNow(), 0);
            driver.release();
        }
    }
    EXPECT_EQ(driver.steps(), 0);
}

TEST(MotionPlot, evenInLengthTheSpeedIsConstant) {
    Driver driver(plain());
    driver.session.view.plot = Plot::speed;
    driver.click(Widget{"strip", {"pace", "u"}});
    EXPECT_GT(spreadOf(heights(driver)), 20);
    driver.click(Widget{"strip", {"pace", "length"}});
    ASSERT_FALSE(heights(driver).empty());
    EXPECT_LT(spreadOf(heights(driver)), 0.01);
}

TEST(MotionPlot, halfTheDurationIsTwiceTheSpeed) {
    Driver driver(plain());
    driver.session.view.plot = Plot::speed;
    driver.frames(1);
    const auto speed = [&] {
        const auto& view = driver.session.view;
        return *driver.session.active()->motion(view.pace, view.duration).at(view.cursor).speed;
    };
    const double before = speed();
    driver.enter(Widget{"strip", {"##duration"}}, "3");
    EXPECT_DOUBLE_EQ(speed(), 2 * before);
}

TEST(MotionPlot, standsBeforeAnAudience) {
    Driver driver(plain());
    driver.session.view.plot = Plot::curvature;
    driver.key(Key::f11);
    driver.frames(2);
    EXPECT_FALSE(heights(driver).empty());
    EXPECT_TRUE(driver.has(Widget{"strip", {"plot", "speed"}}));
    EXPECT_EQ(driver.faults(), "");
}

TEST(MotionPlot, isDrawnForEveryCurveThereIs) {
    Driver driver;
    Curve many = curveOf("cardinal"), same = curveOf("cardinal"), tiny = curveOf("natural");
    for (int i = 0; i < 100'000; ++i) {
        many.points.append(Point{std::sin(0.1 * i), std::cos(0.13 * i)});
    }
    Curve chordal = curveOf("catmull-rom"), huge = curveOf("b-spline", 3);
    chordal.points.set(3, chordal.points.at(2));
    for (std::size_t i = 0; i < 7; ++i) {
        same.points.set(i, Point{1, 2});
        tiny.points.set(i, 1e-300 * sevenPoints().at(i));
        huge.points.set(i, 1e8 * huge.points.at(i));
    }
    const Curve straight = bezierOf({{0, 0}, {0, 0}, {5, 5}, {5, 5}});
    const Curve cusp = bezierOf({{0, 0}, {1, 1}, {0, 1}, {1, 0}});
    for (const Curve& curve : {many, same, tiny, chordal, huge, straight, cusp,
                               curveOf("linear", 1), curveOf("nurbs", 6), curveOf("hermite", 16)}) {
        driver.session.opened(documentOf({curve}), "");
        for (const auto plot : motions) {
            for (const auto pace : {Even::length, Even::parameter}) {
                driver.session.view.plot = plot;
                driver.session.view.pace = pace;
                driver.session.view.duration = pace == Even::length ? 0.1 : 3600;
                driver.frames(2);
                EXPECT_EQ(driver.faults(), "") << curve.family << static_cast<int>(plot);
            }
        }
    }
}

// --- what the graph knows

TEST(MotionGraph, isKeptUntilSomethingChanges) {
    const Study study(std::make_shared<Curve>(curveOf("cardinal")));
    const auto* first = study.motionGraph(Even::length, 6, 700).runs().data();
    EXPECT_EQ(study.motionGraph(Even::length, 6, 700).runs().data(), first);
    const double before = study.motionGraph(Even::length, 6, 700).range(Quantity::speed).high;
    EXPECT_DOUBLE_EQ(study.motionGraph(Even::length, 3, 700).range(Quantity::speed).high,
                     2 * before);
}

TEST(MotionGraph, hasBothValuesAtAJoint) {
    const Study study(std::make_shared<Curve>(curveOf("cardinal")));
    const auto& graph = study.motionGraph(Even::parameter, 6, 700);
    ASSERT_EQ(graph.runs().size(), study.pieces().size());
    ASSERT_EQ(graph.joints().size(), study.pieces().size() - 1);
    for (std::size_t i = 1; i < graph.runs().size(); ++i) {
        const auto& before = graph.runs()[i - 1].back();
        const auto& after = graph.runs()[i].front();
        EXPECT_EQ(before.spot, (Spot{i - 1, 1}));
        EXPECT_EQ(after.spot, (Spot{i, 0}));
        EXPECT_NEAR(before.time, after.time, 1e-12);
        EXPECT_GT(std::abs(*before.moment.acceleration - *after.moment.acceleration), 0.01);
    }
}

TEST(MotionGraph, findsTheExtremesBetweenItsSamples) {
    // (t, t^2) for t from -1 to 2: curvature 2 at the vertex, u = 1/3; speed 2 sqrt(17) at the end.
    const Study study(std::make_shared<Curve>(bezierOf({{-1, 1}, {0.5, -2}, {2, 4}})));
    const auto& graph = study.motionGraph(Even::parameter, 1.5, 50);
    const auto curvature = *graph.extremes(Quantity::curvature);
    EXPECT_NEAR(curvature.greatest.value, 2, 1e-12);
    EXPECT_NEAR(curvature.greatest.time, 0.5, 1e-6);
    EXPECT_TRUE(curvature.greatest.bounded);
    const auto speed = *graph.extremes(Quantity::speed);
    EXPECT_NEAR(speed.greatest.value, 2 * std::sqrt(17), 1e-12);
    EXPECT_EQ(speed.greatest.spot, (Spot{0, 1}));
    EXPECT_NEAR(speed.least.value, 2, 1e-12);
}

TEST(MotionGraph, aCuspFlattensNothing) {
    const Study study(std::make_shared<Curve>(bezierOf({{0, 0}, {1, 1}, {0, 1}, {1, 0}})));
    const auto& graph = study.motionGraph(Even::length, 6, 700);
    const auto& range = graph.range(Quantity::curvature);
    EXPECT_LT(std::max(range.high, -range.low), 100);
    const auto extremes = *graph.extremes(Quantity::curvature);
    EXPECT_FALSE(extremes.greatest.bounded && extremes.least.bounded);
    Scene scene;
    View view;
    view.plot = Plot::curvature;
    const ScreenRect frame{40, 40, 700, 150};
    drawMotion(scene, *motionPlot(study, view, frame), Caption::unit, 1);
    EXPECT_GT(std::ranges::count(scene.marks, SignShape::triangle, &SceneMark::shape), 0);
    for (const auto& stroke : scene.strokes) {
        for (const auto& p : stroke.points) {
            EXPECT_TRUE(p.y >= frame.top - 1e-9 && p.y <= frame.bottom() + 5) << p.y;
        }
    }
}

TEST(MotionGraph, roundingIsNoCurvature) {
    const Study line(std::make_shared<Curve>(bezierOf({{0.1, 0.3}, {0.4, 1.2}, {0.7, 2.1}})));
    EXPECT_TRUE(line.motionGraph(Even::length, 6, 700).range(Quantity::curvature).vanishes);
    EXPECT_FALSE(line.motionGraph(Even::length, 6, 700).range(Quantity::speed).vanishes);
}

TEST(Ticks, areRoundAndApart) {
    for (const double span : {1e-305, 3e-7, 0.9, 1.0, 7.3, 6e4, 1e300}) {
        for (const double pixels : {40.0, 150.0, 1000.0}) {
            const double step = tickStep(span, pixels, 24);
            EXPECT_GE(step / span * pixels, 24 * (1 - 1e-9)) << span;
            EXPECT_LE(step / span * pixels, 24 * 2.6) << span;
        }
    }
    EXPECT_DOUBLE_EQ(tickStep(6, 700, 52), 0.5);
    EXPECT_EQ(magnitudeOf(9999).words, "");
    EXPECT_EQ(magnitudeOf(0).words, "");
    EXPECT_EQ(magnitudeOf(12345).words, "10³ ");
    EXPECT_EQ(magnitudeOf(2e-5).words, "10⁻⁶ ");
    EXPECT_NEAR(magnitudeOf(2e-5).unit, 1e-6, 1e-20);
}

} // namespace
} // namespace splineloft::ui
