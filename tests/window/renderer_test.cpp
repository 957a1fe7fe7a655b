// What the renderer promises, read off its pixels: widths, evenness, round joins, dashes, shapes
// and clipping. Places are off the pixel grid and off the middle, and no stroke runs only along an
// axis, unless the law is about exactly that.
#include "app/image.h"
#include "app/offscreen.h"
#include "app/renderer.h"
#include "ui/drawing.h"
#include "ui/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace splineloft {
namespace {

using ui::Colour;
using ui::ScreenPoint;

constexpr Colour black{0, 0, 0, 255};
constexpr Colour white{255, 255, 255, 255};
constexpr Colour orange{230, 159, 0, 255};
constexpr int across = 240, down = 160; // pixels

// A pixel's brightness as a share of white: how much of a white shape covers it, on black.
double cover(const app::Image& image, int x, int y) {
    return image.pixel(x, y)[0] / 255.0;
}

// The whole white area of a rectangle of pixels; right and bottom are left out.
double area(const app::Image& image, int left, int top, int right, int bottom) {
    double sum = 0;
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
            sum += cover(image, x, y);
        }
    }
    return sum;
}

double area(const app::Image& image) {
    return area(image, 0, 0, image.width, image.height);
}

// A stroke laid out as ui::addStroke does, so that the renderer is tested by its contract alone.
std::vector<ui::RibbonVertex> stroke(const std::vector<ScreenPoint>& points,
                                     const ui::StrokeStyle& style) {
    std::vector<ui::RibbonVertex> ribbon;
    const auto add = [&](ScreenPoint p, double along, float width) {
        ribbon.push_back({static_cast<float>(p.x), static_cast<float>(p.y),
                          static_cast<float>(along), width / 2, style.dash, style.gap,
                          style.colour});
    };
    add(points.front(), 0, 0);
    double along = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) {
            along += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
        }
        add(points[i], along, style.width);
    }
    add(points.back(), along, 0);
    return ribbon;
}

std::vector<ScreenPoint> arc(ScreenPoint middle, double radius, double angle, int segments) {
    std::vector<ScreenPoint> points;
    for (int i = 0; i <= segments; ++i) {
        const auto turn = 0.3 + angle * i / segments;
        points.push_back({middle.x + radius * std::cos(turn), middle.y + radius * std::sin(turn)});
    }
    return points;
}

class RendererTest : public testing::Test {
  protected:
    app::Image draw(const ui::Picture& picture) {
        ui::FrameResult frame;
        frame.background = black;
        frame.pictures.push_back(picture);
        return app::drawOffscreen(renderer_, frame, {across, down, 1});
    }

    app::Image drawStroke(const std::vector<ScreenPoint>& points, const ui::StrokeStyle& style) {
        auto picture = empty();
        picture.ribbons = stroke(points, style);
        return draw(picture);
    }

    app::Image drawSign(const ui::Sign& sign) {
        auto picture = empty();
        picture.signs.push_back(sign);
        return draw(picture);
    }

    static ui::Picture empty() {
        ui::Picture picture;
        picture.frame = {0, 0, across, down};
        picture.background = black;
        return picture;
    }

  private:
    app::OffscreenContext context_;
    app::Renderer renderer_;
};

TEST_F(RendererTest, aLevelStrokeHasItsWidthAndColour) {
    const auto image = drawStroke({{20, 50.5}, {200, 50.5}}, {3, 0, 0, orange});
    for (const auto x : {40, 111, 180}) {
        EXPECT_EQ(image.pixel(x, 48)[0], 0) << "at x = " << x;
        for (const auto y : {49, 50, 51}) {
            const auto* const pixel = image.pixel(x, y);
            EXPECT_EQ((Colour{pixel[0], pixel[1], pixel[2], pixel[3]}), orange) << x << ' ' << y;
        }
        EXPECT_EQ(image.pixel(x, 52)[0], 0) << "at x = " << x;
    }
}

TEST_F(RendererTest, edgesAreSoftAndAlikeOnBothSides) {
    const auto image = drawStroke({{20, 50}, {200, 50}}, {3, 0, 0, white});
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(image.pixel(97, 50 + i)[0], image.pixel(97, 49 - i)[0]) << i;
    }
    EXPECT_NEAR(cover(image, 97, 51), 0.5, 0.01);
    EXPECT_NEAR(cover(image, 97, 52), 0, 0.01);
}

TEST_F(RendererTest, aSlantedStrokeCoversItsLengthTimesItsWidth) {
    const ScreenPoint from{31.3, 40.7}, to{187.9, 121.2};
    const auto length = std::hypot(to.x - from.x, to.y - from.y);
    for (const auto width : {0.3, 0.8, 1.0, 1.7, 3.0, 9.5}) {
        const auto image = drawStroke({from, to}, {static_cast<float>(width), 0, 0, white});
        // Round ends add a disc; a line thinner than a pixel has those of a faint wider one.
        const auto reach = std::max(width, 1.0) / 2;
        const auto ends = std::numbers::pi * reach * reach * std::min(width, 1.0);
        EXPECT_NEAR(area(image), length * width + ends, 0.02 * length * width + 0.5) << width;
    }
}

TEST_F(RendererTest, aTranslucentStrokeIsEvenAtItsJoints) {
    const Colour half{255, 255, 255, 128};
    for (const auto segments : {5, 40, 300, 2000}) {
        const auto points = arc({103.4, 81.2}, 57.3, 5.1, segments);
        const auto image = drawStroke(points, {9, 0, 0, half});
        for (const auto p : points) {
            const auto* const pixel =
                image.pixel(static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)));
            ASSERT_NEAR(pixel[0], 128, 1) << segments << " segments, " << p.x << ' ' << p.y;
        }
        const auto brightest =
            *std::max_element(image.rgba.begin(), image.rgba.end(), [](auto a, auto b) {
                return (a == 255 ? 0 : a) < (b == 255 ? 0 : b); // alpha is 255 everywhere
            });
        EXPECT_LE(brightest, 129) << segments << " segments: a bead at some joint";
    }
}

TEST_F(RendererTest, softEdgesDoNotThickenWithTheNumberOfSegments) {
    const ui::StrokeStyle thin{1.5, 0, 0, white};
    const auto coarse = area(drawStroke(arc({103.4, 81.2}, 57.3, 5.1, 200), thin));
    const auto fine = area(drawStroke(arc({103.4, 81.2}, 57.3, 5.1, 5000), thin));
    EXPECT_NEAR(fine, coarse, 0.002 * coarse);
    EXPECT_NEAR(coarse, 57.3 * 5.1 * 1.5, 0.02 * coarse);
}

TEST_F(RendererTest, aSharpJoinIsRound) {
    const ScreenPoint corner{160.3, 80.6};
    const double width = 24;
    for (const auto turn : {0.5, 1.4, 2.4, 3.0, std::numbers::pi}) { // radians
        const ScreenPoint to{corner.x + 90 * std::cos(turn), corner.y + 90 * std::sin(turn)};
        const auto image = drawStroke({{corner.x - 110, corner.y}, corner, to},
                                      {static_cast<float>(width), 0, 0, {255, 255, 255, 160}});
        // Around the outside of the turn, just within and just beyond half the width.
        for (double out = 0; out <= turn; out += 0.1) {
            const auto angle = out - std::numbers::pi / 2;
            const auto at = [&](double distance) {
                return cover(image, static_cast<int>(corner.x + distance * std::cos(angle)),
                             static_cast<int>(corner.y + distance * std::sin(angle)));
            };
            EXPECT_NEAR(at(width / 2 - 1.5), 160.0 / 255, 0.01) << turn << ' ' << out;
            EXPECT_EQ(at(width / 2 + 1.5), 0) << turn << ' ' << out;
        }
        EXPECT_LE(area(image) / (160.0 / 255), (110 + 90) * width + 500) << "drawn twice";
    }
}

TEST_F(RendererTest, dashesKeepTheirPeriodAcrossJoints) {
    std::vector<ScreenPoint> points;
    for (double x = 20; x <= 220; x += 1.7) {
        points.push_back({x, 60.5});
    }
    const auto image = drawStroke(points, {3, 9, 6, white});
    for (int x = 24; x < 200; ++x) {
        EXPECT_NEAR(cover(image, x, 60), cover(image, x + 15, 60), 0.02) << x;
        const auto phase = (x - 20) % 15;
        EXPECT_NEAR(cover(image, x, 60), phase < 9 ? 1 : 0, 0.02) << x;
    }
}

TEST_F(RendererTest, everyTurnOfADashedStrokeHasItsShareOfInk) {
    const auto whole = area(drawStroke(arc({103.4, 81.2}, 57.3, 5.1, 90), {2, 0, 0, white}));
    const auto dashed = area(drawStroke(arc({103.4, 81.2}, 57.3, 5.1, 90), {2, 5, 3, white}));
    EXPECT_NEAR(dashed / whole, 5.0 / 8, 0.02);
}

TEST_F(RendererTest, noLengthDrawsNothing) {
    const ScreenPoint p{70.3, 61.8};
    EXPECT_EQ(area(drawStroke({p}, {5, 0, 0, white})), 0);
    EXPECT_EQ(area(drawStroke({p, p, p}, {5, 4, 4, white})), 0);
    const auto plain = area(drawStroke({p, {150.1, 90.2}}, {5, 0, 0, white}));
    const auto repeated = area(drawStroke({p, p, {150.1, 90.2}, {150.1, 90.2}}, {5, 0, 0, white}));
    EXPECT_NEAR(repeated, plain, 1e-6);
}

TEST_F(RendererTest, placesThatAreNoNumbersOrFarAwayDoNoHarm) {
    const auto infinite = std::numeric_limits<double>::infinity();
    const auto nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<ScreenPoint> fine{{20.2, 31.7}, {90.4, 71.3}};
    for (const auto bad : {infinite, -infinite, nan, 1e30, -3e9}) {
        auto picture = empty();
        picture.ribbons = stroke({{20.1, 120.3}, {bad, 100}, {bad, bad}}, {4, 0, 0, white});
        picture.signs.push_back(
            {static_cast<float>(bad), 20, 5, 1, 0, ui::SignShape::disc, white, white});
        const auto more = stroke(fine, {3, 0, 0, white});
        picture.ribbons.insert(picture.ribbons.end(), more.begin(), more.end());
        EXPECT_NEAR(area(draw(picture)), area(drawStroke(fine, {3, 0, 0, white})), 1e-6) << bad;
    }
    // A stroke that only leaves the window is still a stroke.
    const auto image = drawStroke({{-5000, 50.5}, {5000, 50.5}}, {3, 0, 0, white});
    EXPECT_NEAR(area(image), across * 3, 1);
}

TEST_F(RendererTest, strokesAreNotJoinedToEachOther) {
    auto picture = empty();
    const auto first = stroke({{20.3, 20.4}, {60.1, 25.2}}, {3, 0, 0, white});
    const auto second = stroke({{180.2, 140.3}, {220.7, 130.9}}, {3, 0, 0, white});
    picture.ribbons = first;
    picture.ribbons.insert(picture.ribbons.end(), second.begin(), second.end());
    const auto image = draw(picture);
    EXPECT_EQ(area(image, 70, 0, 170, down), 0);
    EXPECT_GT(area(image, 0, 0, 70, down), 100);
    EXPECT_GT(area(image, 170, 0, across, down), 100);
}

TEST_F(RendererTest, signsCoverTheAreaOfTheirShape) {
    const auto r = 9.0;
    const auto areaOf = [&](ui::SignShape shape, float angle) {
        return area(
            drawSign({111.3f, 71.8f, static_cast<float>(r), 0, angle, shape, white, white}));
    };
    for (const auto angle : {0.0f, 0.4f, 1.9f}) {
        EXPECT_NEAR(areaOf(ui::SignShape::disc, angle), std::numbers::pi * r * r, 1) << angle;
        EXPECT_NEAR(areaOf(ui::SignShape::diamond, angle), 2 * r * r, 2) << angle;
        EXPECT_NEAR(areaOf(ui::SignShape::square, angle), 4 * r * r, 3) << angle;
        EXPECT_NEAR(areaOf(ui::SignShape::triangle, angle), std::sqrt(3.0) * r * r, 3) << angle;
        EXPECT_EQ(areaOf(ui::SignShape::ring, angle), 0) << "a ring is its outline only";
    }
}

TEST_F(RendererTest, signsReachAsFarAsTheirShapeDoes) {
    const auto lit = [&](ui::SignShape shape, int x, int y) {
        return cover(drawSign({111.5f, 71.5f, 8, 0, 0, shape, white, white}), x, y) > 0.5;
    };
    // Half way along the diagonal of the box: in the disc and the square, not in the diamond.
    EXPECT_TRUE(lit(ui::SignShape::disc, 116, 76));
    EXPECT_TRUE(lit(ui::SignShape::square, 116, 76));
    EXPECT_FALSE(lit(ui::SignShape::diamond, 116, 76));
    // The corner of the box: in the square alone.
    EXPECT_FALSE(lit(ui::SignShape::disc, 118, 78));
    EXPECT_TRUE(lit(ui::SignShape::square, 118, 78));
    // The tips, across and down, are in all three; the triangle points up.
    for (const auto shape : {ui::SignShape::disc, ui::SignShape::diamond, ui::SignShape::square}) {
        EXPECT_TRUE(lit(shape, 117, 71));
        EXPECT_TRUE(lit(shape, 111, 65));
    }
    EXPECT_TRUE(lit(ui::SignShape::triangle, 111, 64));
    EXPECT_FALSE(lit(ui::SignShape::triangle, 111, 79));
}

TEST_F(RendererTest, outlinesLieInsideTheShape) {
    const Colour fill{230, 0, 0, 255}, outline{0, 180, 0, 255};
    const auto image = drawSign({111.5f, 71.5f, 9, 3, 0, ui::SignShape::disc, fill, outline});
    EXPECT_EQ(image.pixel(111, 71)[0], 230);
    EXPECT_EQ(image.pixel(111 + 7, 71)[1], 180);
    EXPECT_EQ(image.pixel(111 + 7, 71)[0], 0);
    EXPECT_EQ(image.pixel(111 + 10, 71)[1], 0);
    const auto ring = drawSign({111.5f, 71.5f, 9, 3, 0, ui::SignShape::ring, fill, outline});
    EXPECT_EQ(ring.pixel(111, 71)[0], 0) << "what lies under a ring shows through it";
    EXPECT_EQ(ring.pixel(111 + 7, 71)[1], 180);
}

TEST_F(RendererTest, nothingLeavesThePicturesFrame) {
    auto picture = empty();
    picture.frame = {40, 30, 100, 60};
    picture.background = {10, 20, 30, 255};
    picture.areas.push_back({{0, 40, across, 10}, {255, 0, 0, 255}});
    picture.ribbons = stroke({{3.3, 2.2}, {233.1, 151.7}}, {20, 0, 0, white});
    picture.signs.push_back({40, 60, 15, 2, 0, ui::SignShape::disc, white, orange});
    const auto image = draw(picture);
    const auto inside = area(image, 40, 30, 140, 90);
    EXPECT_GT(inside, 1000);
    EXPECT_NEAR(area(image), inside, 1e-9);
    EXPECT_EQ(image.pixel(139, 31)[2], 30);
}

TEST_F(RendererTest, areasAreFilledExactlyAlsoBetweenPixels) {
    auto picture = empty();
    picture.areas.push_back({{20.25, 30.5, 50.5, 20.25}, white});
    const auto image = draw(picture);
    EXPECT_NEAR(area(image), 50.5 * 20.25, 3);
    EXPECT_NEAR(cover(image, 20, 40), 0.75, 0.01);
    EXPECT_NEAR(cover(image, 40, 30), 0.5, 0.01);
    EXPECT_NEAR(cover(image, 40, 40), 1, 0);
}

TEST_F(RendererTest, laterThingsLieAboveEarlierOnes) {
    auto picture = empty();
    picture.areas.push_back({{20, 20, 100, 100}, {0, 0, 200, 255}});
    picture.ribbons = stroke({{20.2, 60.1}, {120.3, 62.4}}, {10, 0, 0, {0, 200, 0, 255}});
    picture.signs.push_back({70, 61, 8, 0, 0, ui::SignShape::disc, {200, 0, 0, 255}, black});
    const auto image = draw(picture);
    EXPECT_EQ(image.pixel(30, 30)[2], 200);
    EXPECT_EQ(image.pixel(40, 60)[1], 200);
    EXPECT_EQ(image.pixel(70, 61)[0], 200);
}

} // namespace
} // namespace splineloft
