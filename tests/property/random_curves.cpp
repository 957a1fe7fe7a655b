#include "tests/property/random_curves.h"

#include "core/spline/catalog.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace splineloft {

void PrintTo(const Point& point, std::ostream* stream) {
    stream->precision(17);
    for (int c = 0; c < point.dimension(); ++c) {
        *stream << (c == 0 ? "(" : ", ") << point[c];
    }
    *stream << ')';
}

} // namespace splineloft

namespace splineloft::testing_curves {

double Dice::between(double low, double high) {
    constexpr double unit = 1.0 / (1ULL << 53U);
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * unit);
}

int Dice::whole(int low, int high) {
    const auto count = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(engine_() % count);
}

double Dice::onGrid(double extent) {
    constexpr double step = 1.0 / (1 << 20);
    return std::round(between(-extent, extent) / step) * step;
}

Point Dice::pointOnGrid(int dimension, double extent) {
    Point point(dimension);
    for (int c = 0; c < dimension; ++c) {
        point[c] = onGrid(extent);
    }
    return point;
}

std::vector<CurveForm> formsOf(const std::string& family) {
    const Family* found = findFamily(family);
    std::vector<CurveForm> forms;
    for (const Ends ends : found->ends) {
        forms.push_back({family, false, ends});
    }
    if (found->closable) {
        forms.push_back({family, true, found->ends.front()});
    }
    return forms;
}

std::vector<CurveForm> everyForm() {
    std::vector<CurveForm> forms;
    for (const auto& id : familyIds()) {
        std::ranges::copy(formsOf(id), std::back_inserter(forms));
    }
    return forms;
}

Curve emptyCurve(const CurveForm& form, int dimension) {
    Curve curve;
    curve.family = form.family;
    curve.closed = form.closed;
    curve.ends = form.ends;
    curve.points = Points(dimension);
    curve.tangents = Points(dimension);
    curve.coordinates.clear();
    for (int c = 0; c < dimension; ++c) {
        curve.coordinates.push_back("c" + std::to_string(c));
    }
    return curve;
}

void rollParameters(Curve& curve, Dice& dice) {
    for (const auto& p : familyOf(curve).parameters) {
        double value = dice.between(p.sliderLeast, p.sliderMost);
        if (p.scale == Scale::ratio) {
            value = std::exp(dice.between(std::log(p.sliderLeast), std::log(p.sliderMost)));
        } else if (p.scale == Scale::whole) {
            value = dice.whole(static_cast<int>(p.sliderLeast), static_cast<int>(p.sliderMost));
        }
        const double ends[] = {p.sliderLeast, p.neutral, p.sliderMost};
        curve.parameters[std::string(p.key)] = dice.oneIn(4) ? ends[dice.whole(0, 2)] : value;
    }
}

void rollPoints(Curve& curve, std::size_t count, const Point& center, double extent, Dice& dice) {
    const int dimension = center.dimension();
    curve.points = Points(dimension);
    curve.tangents = Points(dimension);
    for (std::size_t i = 0; i < count; ++i) {
        curve.points.append(center + dice.pointOnGrid(dimension, extent));
        if (familyOf(curve).usesTangents) {
            curve.tangents.append(dice.pointOnGrid(dimension, extent));
        }
    }
}

Curve randomCurve(const CurveForm& form, std::uint64_t seed) {
    Dice dice(seed);
    const int dimension = dice.oneIn(10) ? maxDimension : dice.whole(1, 6);
    Curve curve = emptyCurve(form, dimension);
    rollParameters(curve, dice);
    const auto count = fewestPoints(curve) + static_cast<std::size_t>(dice.whole(0, 9));
    rollPoints(curve, count, dice.pointOnGrid(dimension, dice.oneIn(2) ? 1000 : 8),
               dice.between(1, 16), dice);
    return curve;
}

Curve withPoints(Curve curve, const std::vector<Point>& points) {
    curve.points = Points(curve.points.dimension());
    for (const auto& point : points) {
        curve.points.append(point);
    }
    return curve;
}

std::string wordsOf(const Curve& curve) {
    std::ostringstream words;
    words.precision(17);
    words << curve.family;
    for (const auto& [key, value] : curve.parameters) {
        words << ' ' << key << '=' << value;
    }
    words << (curve.closed ? " closed" : " ends=" + std::string(nameOf(curve.ends)));
    words << ' ' << curve.points.size() << " points of " << curve.points.dimension();
    return words.str();
}

double farthest(const Curve& curve) {
    double size = 0;
    for (const auto* table : {&curve.points, &curve.tangents}) {
        for (const double x : table->values()) {
            size = std::max(size, std::abs(x));
        }
    }
    return size;
}

double amplification(const BlendPieces& blends) {
    double most = 1;
    for (std::size_t i = 0; i < blends.size(); ++i) {
        for (const auto& blend : blends[i]) {
            double sum = 0;
            for (const auto& share : blend.shares()) {
                sum += std::abs(share.weight);
            }
            most = std::max(most, sum);
        }
    }
    return most;
}

double roundingOf(const Curve& curve, const BlendPieces& blends) {
    constexpr double eachTerm = 4;
    return eachTerm * (blends.degree() + 5) * std::numeric_limits<double>::epsilon() *
           farthest(curve) * amplification(blends);
}

std::vector<std::string> familyIds() {
    std::vector<std::string> ids;
    for (const auto& family : catalog()) {
        ids.emplace_back(family.id);
    }
    return ids;
}

std::string testNameOf(const testing::TestParamInfo<std::string>& info) {
    auto name = info.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

void expectNear(const Point& ours, const Point& wanted, double tolerance, const std::string& what) {
    ASSERT_EQ(ours.dimension(), wanted.dimension()) << what;
    for (int c = 0; c < ours.dimension(); ++c) {
        EXPECT_NEAR(ours[c], wanted[c], tolerance) << what << ", coordinate " << c;
    }
}

} // namespace splineloft::testing_curves
