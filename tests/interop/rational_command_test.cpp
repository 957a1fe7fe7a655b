// What the command line says about NURBS, knots of one's own and local parameters: against the
// reference values, and where the truth is known, the circle above all.
#include "core/formats/file.h"
#include "tests/interop/run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace splineloft {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json answer(const std::vector<std::string>& arguments, const std::string& document) {
    const auto ran = run(arguments, document);
    EXPECT_EQ(ran.exitCode(), 0) << ran.err;
    return ran.exitCode() == 0 ? json::parse(ran.out) : json();
}

double numberIn(const json& digits) {
    const auto& text = digits.get_ref<const std::string&>();
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

void expectNear(const json& ours, const json& wanted, double tolerance, const std::string& where) {
    ASSERT_EQ(ours.size(), wanted.size()) << where;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        EXPECT_NEAR(ours[i].get<double>(), numberIn(wanted[i]), tolerance) << where << ", " << i;
    }
}

// --- against the reference values

std::vector<std::string> spotOf(const json& query) {
    if (query.contains("t")) {
        return {"--t", query["t"]};
    }
    return {"--segment", query["segment"].dump(), "--u", query["u"]};
}

/// Compares what `eval` and `basis` print; returns how many spots.
int compareCase(const json& item, const std::string& name) {
    json described = item;
    described.erase("queries");
    described.erase("arc_length");
    described.erase("u_at_even_eighths");
    const auto document = curves(described.dump());
    double size = 1;
    for (const auto& point : item["points"]) {
        for (const double x : point) {
            size = std::max(size, std::abs(x));
        }
    }
    int spots = 0;
    for (const auto& query : item["queries"]) {
        auto spot = spotOf(query);
        const auto where = name + " at " + spot.back();
        std::vector<std::string> arguments = {"eval", "-"};
        arguments.insert(arguments.end(), spot.begin(), spot.end());
        const auto jet = answer(arguments, document);
        expectNear(jet[0]["position"], query["position"], 1e-13 * size, where);
        if (query.contains("first")) {
            expectNear(jet[0]["first"], query["first"], 1e-13 * size, where + ", first");
            expectNear(jet[0]["second"], query["second"], 1e-11 * size, where + ", second");
        }
        if (query.contains("basis")) {
            arguments[0] = "basis";
            const auto basis = answer(arguments, document);
            expectNear(basis[0]["weights"], query["basis"], 1e-13, where + ", basis");
        }
        ++spots;
    }
    return spots;
}

class EvalAndBasis : public testing::TestWithParam<std::string> {};

TEST_P(EvalAndBasis, printTheReferenceValues) {
    std::ifstream file(std::string(SPLINELOFT_TESTS_DIR) + "/golden/" + GetParam() + ".json");
    const json cases = json::parse(file);
    int spots = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto& item = cases[i];
        if (item.contains("knots") || item.contains("weights") || item.contains("local")) {
            spots += compareCase(item, GetParam() + " case " + std::to_string(i));
        }
    }
    EXPECT_GT(spots, 10);
}

INSTANTIATE_TEST_SUITE_P(Golden, EvalAndBasis, testing::Values("nurbs", "b-spline", "beta"),
                         [](const auto& given) {
                             return given.param == "b-spline" ? "b_spline" : given.param;
                         });

// --- the circle of radius 3, of four quadratic pieces

std::string circle() {
    std::ifstream file(std::string(SPLINELOFT_TESTS_DIR) + "/../assets/examples/circle.json");
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Circle, isOneEverywhere) {
    std::string places = "0";
    for (int i = 1; i <= 64; ++i) {
        places += "," + json(i / 64.0).dump();
    }
    const auto spots = answer({"eval", "-", "--t", places}, circle());
    ASSERT_EQ(spots.size(), 65u);
    for (const auto& spot : spots) {
        const double x = spot["position"][0];
        const double y = spot["position"][1];
        EXPECT_NEAR(std::hypot(x, y), 3, 4e-15) << spot["t"];
        EXPECT_NEAR(spot["curvature"].get<double>(), 1.0 / 3, 1e-13) << spot["t"];
        const double along =
            x * spot["first"][0].get<double>() + y * spot["first"][1].get<double>();
        EXPECT_NEAR(along, 0, 1e-12) << "the derivative is square to the radius";
    }
    EXPECT_EQ(spots[0]["position"], (json{3.0, 0.0}));
    EXPECT_EQ(spots[64]["position"], (json{3.0, 0.0}));
}

TEST(Circle, hasItsLengthAndBounds) {
    const auto measured = answer({"measure", "-"}, circle());
    EXPECT_NEAR(measured["length"].get<double>(), 6 * std::numbers::pi, 1e-12);
    for (const std::size_t c : {0u, 1u}) {
        EXPECT_NEAR(measured["bounds"]["low"][c].get<double>(), -3, 1e-14);
        EXPECT_NEAR(measured["bounds"]["high"][c].get<double>(), 3, 1e-14);
    }
    ASSERT_EQ(measured["joints"].size(), 3u);
    for (const auto& joint : measured["joints"]) {
        EXPECT_EQ(joint["g"], 2) << "a circle turns evenly: " << joint;
        EXPECT_EQ(joint["c"], 1) << "though its parameter does not: " << joint;
    }
}

TEST(Circle, isSampledEvenlyByLength) {
    const auto ran = run({"sample", "-", "--count", "13", "--spacing", "length"}, circle());
    ASSERT_EQ(ran.exitCode(), 0) << ran.err;
    std::istringstream lines(ran.out);
    std::string line;
    std::getline(lines, line);
    for (int i = 0; std::getline(lines, line); ++i) {
        std::vector<double> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) {
            cells.push_back(std::stod(cell));
        }
        const double angle = std::numbers::pi / 6 * i;
        ASSERT_GE(cells.size(), 5u) << line;
        EXPECT_NEAR(cells[1], 3 * angle, 1e-11) << line;
        EXPECT_NEAR(cells[3], 3 * std::cos(angle), 1e-11) << line;
        EXPECT_NEAR(cells[4], 3 * std::sin(angle), 1e-11) << line;
    }
}

TEST(Circle, isCheckedAndHasNoPolynomialOfItsShape) {
    EXPECT_EQ(run({"check", "-"}, circle()).out, "standard input: ok (2 curves, 14 points)\n");
    const auto out =
        fs::temp_directory_path() / ("splineloft-circle-" + std::to_string(::getpid()) + ".json");
    for (const std::string family : {"bezier-spline", "hermite"}) {
        const auto ran = run({"convert", "-", "--family", family, "-o", out}, circle());
        EXPECT_EQ(ran.exitCode(), 1);
        EXPECT_NE(ran.err.find("/curves/0/family: "), std::string::npos) << ran.err;
        EXPECT_NE(ran.err.find("rational"), std::string::npos) << ran.err;
    }
    ASSERT_EQ(run({"convert", "-", "-o", out}, circle()).exitCode(), 0);
    EXPECT_EQ(*readFile(out.string()), circle()) << "as it was written";
    fs::remove(out);
}

// --- knots at which a B-spline is broken

/// Degree 2 with a knot three times over at 1: two parabolas that do not meet.
const std::string broken = curves(R"({"name": "broken", "family": "b-spline",
    "parameters": {"degree": 2}, "knots": [-1, -1, -1, 1, 1, 1, 2, 2, 2],
    "points": [[1, 1], [2, 5], [4, 2], [5, 7], [8, 6], [9, -1]]})");

TEST(BrokenSpline, isDefinedAtBothEndsAndOnBothSides) {
    const auto spots = answer({"eval", "-", "--t", "-1,1,2"}, broken);
    EXPECT_EQ(spots[0]["position"], (json{1.0, 1.0}));
    EXPECT_EQ(spots[1]["position"], (json{5.0, 7.0})) << "a knot belongs to what begins there";
    EXPECT_EQ(spots[1]["segment"], 1);
    EXPECT_EQ(spots[2]["position"], (json{9.0, -1.0}));
    const auto left = answer({"eval", "-", "--segment", "0", "--u", "1"}, broken);
    EXPECT_EQ(left[0]["position"], (json{4.0, 2.0})) << "and this is where the piece before ends";
    EXPECT_EQ(left[0]["t"], 1);
    EXPECT_EQ(left[0]["first"], (json{4.0, -6.0}));
    const auto basis = answer({"basis", "-", "--segment", "0", "--u", "1"}, broken);
    EXPECT_EQ(basis[0]["weights"], (json{0, 0, 1, 0, 0, 0}));
    EXPECT_EQ(answer({"basis", "-", "--t", "1"}, broken)[0]["weights"], (json{0, 0, 0, 1, 0, 0}));
    EXPECT_EQ(answer({"basis", "-", "--t", "2"}, broken)[0]["weights"], (json{0, 0, 0, 0, 0, 1}));
    EXPECT_EQ(run({"eval", "-", "--t", "2.5"}, broken).exitCode(), 1);
    EXPECT_EQ(run({"eval", "-", "--t", "-1.5"}, broken).exitCode(), 1);
}

TEST(BrokenSpline, isMeasuredAsBroken) {
    const auto measured = answer({"measure", "-"}, broken);
    ASSERT_EQ(measured["joints"].size(), 1u);
    EXPECT_EQ(measured["joints"][0]["t"], 1);
    EXPECT_EQ(measured["joints"][0]["c"], -1);
    EXPECT_EQ(measured["joints"][0]["g"], -1);
    EXPECT_NEAR(measured["joints"][0]["residuals"]["position"].get<double>(), std::hypot(1, 5),
                1e-14);
}

// Knots of unevenKnots spacing, of multiplicity 2 at 4, with t from 1 to 9.
const std::string unevenKnots = R"({"family": "b-spline", "ends": "none",
    "knots": [-2, 0, 0.5, 1, 4, 4, 7, 9, 9.5, 11, 12],
    "points": [[1, 1], [2, 5], [4, 2], [5, 7], [8, 6], [9, -1], [3, 3]]})";

TEST(OwnKnots, convertToBezierPointsOfTheSameShape) {
    const auto out =
        fs::temp_directory_path() / ("splineloft-knots-" + std::to_string(::getpid()) + ".json");
    ASSERT_EQ(run({"convert", "-", "--family", "bezier-spline", "-o", out}, curves(unevenKnots))
                  .exitCode(),
              0);
    for (const std::string segment : {"0", "1", "2"}) {
        const std::vector<std::string> spots = {"--segment", segment, "--u", "0,0.25,0.7,1"};
        auto before = std::vector<std::string>{"eval", "-"};
        auto after = std::vector<std::string>{"eval", out};
        before.insert(before.end(), spots.begin(), spots.end());
        after.insert(after.end(), spots.begin(), spots.end());
        const auto was = answer(before, curves(unevenKnots));
        const auto is = answer(after, "");
        for (std::size_t i = 0; i < was.size(); ++i) {
            for (const std::size_t c : {0u, 1u}) {
                EXPECT_NEAR(was[i]["position"][c].get<double>(), is[i]["position"][c], 1e-13);
            }
        }
    }
    fs::remove(out);
    const auto joints = answer({"measure", "-"}, curves(unevenKnots))["joints"];
    ASSERT_EQ(joints.size(), 2u);
    EXPECT_EQ(joints[0]["t"], 4);
    EXPECT_EQ(joints[0]["c"], 1) << "a double knot costs one derivative";
    EXPECT_EQ(joints[1]["t"], 7);
    EXPECT_EQ(joints[1]["c"], 2);
}

TEST(OwnKnots, areRefusedWithTheirPlace) {
    auto bad = json::parse(unevenKnots);
    bad["knots"][5] = 3.5;
    const auto ran = run({"eval", "-", "--t", "2"}, curves(bad.dump()));
    EXPECT_EQ(ran.exitCode(), 1);
    EXPECT_EQ(ran.err, "standard input: /curves/0/knots/5: falls from 4 to 3.5; right would be: "
                       "knots that never fall\n");
}

TEST(Families, sayWhatTheyTake) {
    for (const auto& family : answer({"families", "--json"}, "")) {
        const std::string id = family["id"];
        EXPECT_EQ(family["knots"], id == "b-spline" || id == "nurbs") << id;
        EXPECT_EQ(family["weights"], id == "nurbs") << id;
        for (const auto& parameter : family["parameters"]) {
            EXPECT_EQ(parameter["local"],
                      id == "cardinal" || id == "kochanek-bartels" || id == "beta")
                << id << ' ' << parameter["key"];
        }
    }
}

} // namespace
} // namespace splineloft
