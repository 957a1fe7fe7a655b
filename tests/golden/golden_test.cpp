// Every family against reference values that were computed at 60 digits by other formulas
// (tests/golden/README.md says how).
#include "core/spline/catalog.h"
#include "core/spline/curve.h"
#include "core/spline/measure/length.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <fstream>

namespace splineloft {
namespace {

using nlohmann::json;

double number(const json& text) {
    const auto& digits = text.get_ref<const std::string&>();
    double value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

Points tableOf(const json& rows) {
    Points points(static_cast<int>(rows.front().size()));
    for (const auto& row : rows) {
        points.append(Point(row.get<std::vector<double>>()));
    }
    return points;
}

Ends endsNamed(const std::string& name) {
    for (const auto ends : {Ends::open, Ends::doubled, Ends::reflected, Ends::clamped}) {
        if (name == nameOf(ends)) {
            return ends;
        }
    }
    return Ends::none;
}

Curve curveOf(const json& item) {
    Curve curve;
    curve.family = item["family"];
    curve.parameters = item["parameters"].get<std::map<std::string, double>>();
    curve.points = tableOf(item["points"]);
    if (item.contains("tangents")) {
        curve.tangents = tableOf(item["tangents"]);
    }
    curve.coordinates.clear();
    for (int i = 0; i < curve.points.dimension(); ++i) {
        curve.coordinates.push_back("c" + std::to_string(i));
    }
    curve.closed = item["closed"];
    curve.ends = endsNamed(item["ends"]);
    curve.knots = item.value("knots", std::vector<double>());
    curve.weights = item.value("weights", std::vector<double>());
    curve.local = item.value("local", std::map<std::string, std::vector<double>>());
    return curve;
}

double sizeOf(const Points& points) {
    double size = 1;
    for (const double x : points.values()) {
        size = std::max(size, std::abs(x));
    }
    return size;
}

void expectPoint(const Point& ours, const json& wanted, double tolerance,
                 const std::string& where) {
    ASSERT_EQ(static_cast<std::size_t>(ours.dimension()), wanted.size()) << where;
    for (int c = 0; c < ours.dimension(); ++c) {
        EXPECT_NEAR(ours[c], number(wanted[static_cast<std::size_t>(c)]), tolerance)
            << where << ", coordinate " << c;
    }
}

/// Checks one case; returns how many values it compared.
int checkCase(const json& item, const std::string& name) {
    const Curve curve = curveOf(item);
    const Pieces pieces = piecesOf(curve);
    const BlendPieces blends = blendsOf(curve);
    const double size = sizeOf(curve.points);
    int compared = 0;
    for (const auto& query : item["queries"]) {
        const bool byParameter = query.contains("t");
        const Spot spot = byParameter ? pieces.knots().locate(number(query["t"]))
                                      : Spot{query["segment"], number(query["u"])};
        const auto where =
            name + ", segment " + std::to_string(spot.segment) + ", u " + std::to_string(spot.u);
        EXPECT_LT(spot.segment, pieces.size()) << where;
        if (spot.segment >= pieces.size()) {
            return compared;
        }
        const Jet jet = pieces.jet(spot);
        expectPoint(jet.position, query["position"], 1e-13 * size, where + ", position");
        if (query.contains("first")) {
            expectPoint(jet.first, query["first"], 1e-13 * size, where + ", first");
            expectPoint(jet.second, query["second"], 1e-11 * size, where + ", second");
        }
        Point blended(curve.points.dimension());
        const Blend basis = blends.basis(spot);
        for (std::size_t i = 0; query.contains("basis") && i < query["basis"].size(); ++i) {
            EXPECT_NEAR(basis.weight(i), number(query["basis"][i]), 1e-13) << where;
        }
        for (const auto& [control, weight] : basis.shares()) {
            const auto n = curve.points.size();
            blended +=
                weight * (control < n ? curve.points.at(control) : curve.tangents.at(control - n));
        }
        expectPoint(blended, query["position"], 1e-13 * size, where + ", blended");
        ++compared;
    }
    if (item.contains("arc_length")) {
        const ArcLength lengths(pieces);
        const double whole = number(item["arc_length"]);
        EXPECT_NEAR(lengths.total(), whole, 1e-13 * whole) << name;
        for (std::size_t i = 0;
             item.contains("u_at_even_eighths") && i < item["u_at_even_eighths"].size(); ++i) {
            const double part = static_cast<double>(i + 1) / 8;
            EXPECT_NEAR(lengths.spotAt(part * whole).u, number(item["u_at_even_eighths"][i]), 1e-13)
                << name << ", eighth " << i + 1;
        }
        ++compared;
    }
    return compared;
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, agrees) {
    std::ifstream file(std::string(SPLINELOFT_TESTS_DIR) + "/golden/" + GetParam() + ".json");
    const json cases = json::parse(file);
    int compared = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const int inCase = checkCase(cases[i], GetParam() + " case " + std::to_string(i));
        EXPECT_GT(inCase, 0) << "case " << i << " compares nothing";
        compared += inCase;
    }
    EXPECT_GT(compared, 0);
}

std::vector<std::string> familyIds() {
    std::vector<std::string> ids;
    for (const auto& family : catalog()) {
        ids.emplace_back(family.id);
    }
    return ids;
}

INSTANTIATE_TEST_SUITE_P(Families, Golden, testing::ValuesIn(familyIds()), [](const auto& given) {
    auto name = given.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

} // namespace
} // namespace splineloft
