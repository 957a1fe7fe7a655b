// The command line, called as main calls it: what it prints.
#include "core/formats/file.h"
#include "tests/interop/sample_curves.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace splineloft {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json evaluated(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"eval", "-"});
    const auto ran = run(arguments, sample);
    EXPECT_EQ(ran.exitCode(), 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    return json::parse(ran.out);
}

TEST(CommandLine, evaluatesOnASegment) {
    const auto spots = evaluated({"--curve", "0", "--segment", "0", "--u", "0,0.25,1"});
    ASSERT_EQ(spots.size(), 3u);
    EXPECT_EQ(spots[1]["segment"], 0);
    EXPECT_EQ(spots[1]["u"], 0.25);
    EXPECT_EQ(spots[1]["t"], 0.25);
    EXPECT_EQ(spots[1]["position"], (json{1.75, 3.0}));
    EXPECT_EQ(spots[1]["first"], (json{3.0, 4.0}));
    EXPECT_EQ(spots[1]["second"], (json{0.0, 0.0}));
    EXPECT_EQ(spots[1]["curvature"], 0);
    EXPECT_EQ(spots[2]["position"], (json{4.0, 6.0}));
}

TEST(CommandLine, evaluatesAtParameters) {
    const auto spots = evaluated({"--curve", "path", "--t", "0,1.5,3"});
    ASSERT_EQ(spots.size(), 3u);
    EXPECT_EQ(spots[0]["position"], (json{-3.5, 0.25}));
    EXPECT_EQ(spots[1]["segment"], 1);
    EXPECT_EQ(spots[1]["u"], 0.5);
    EXPECT_EQ(spots[2]["segment"], 2);
    EXPECT_EQ(spots[2]["u"], 1);
    EXPECT_EQ(spots[2]["position"], (json{4.0, 1.0}));
}

TEST(CommandLine, derivesByWhatWasAskedFor) {
    const auto byU = evaluated({"--curve", "uneven", "--segment", "1", "--u", "0.5"});
    const double t = byU[0]["t"];
    const auto byT = evaluated({"--curve", "uneven", "--t", json(t).dump()});
    const double interval = std::hypot(5.0, 2.0);
    for (const std::size_t c : {0u, 1u}) {
        EXPECT_NEAR(byT[0]["position"][c], byU[0]["position"][c], 1e-12);
        EXPECT_NEAR(byT[0]["first"][c].get<double>() * interval, byU[0]["first"][c], 1e-12);
        EXPECT_NEAR(byT[0]["second"][c].get<double>() * interval * interval, byU[0]["second"][c],
                    1e-11);
    }
    EXPECT_NEAR(byT[0]["curvature"], byU[0]["curvature"], 1e-12);
}

TEST(CommandLine, hasNoCurvatureAtRest) {
    const auto spots = evaluated({"--curve", "h", "--t", "0"});
    EXPECT_TRUE(spots[0]["curvature"].is_null());
}

TEST(CommandLine, weightsRebuildTheCurve) {
    for (const std::string curve : {"path", "uneven"}) {
        const auto spots = evaluated({"--curve", curve, "--t", "0,0.3,2.7"});
        const auto ran = run({"basis", "-", "--curve", curve, "--t", "0,0.3,2.7"}, sample);
        ASSERT_EQ(ran.exitCode(), 0) << ran.err;
        const auto basis = json::parse(ran.out);
        const json described = json::parse(sample)["curves"][curve == "path" ? 0 : 2];
        for (std::size_t i = 0; i < spots.size(); ++i) {
            double x = 0;
            double sum = 0;
            ASSERT_EQ(basis[i]["weights"].size(), 4u);
            for (std::size_t k = 0; k < 4; ++k) {
                const double weight = basis[i]["weights"][k];
                sum += weight;
                x += weight * described["points"][k][0].get<double>();
            }
            EXPECT_EQ(basis[i]["t"], spots[i]["t"]);
            EXPECT_NEAR(sum, 1, 1e-14);
            EXPECT_NEAR(x, spots[i]["position"][0], 1e-12);
            EXPECT_FALSE(basis[i].contains("tangentWeights"));
        }
    }
}

TEST(CommandLine, givesWeightsOfTangentsWhereThereAreAny) {
    const auto ran = run({"basis", "-", "--curve", "h", "--segment", "0", "--u", "0.5"}, sample);
    ASSERT_EQ(ran.exitCode(), 0) << ran.err;
    const auto basis = json::parse(ran.out);
    EXPECT_EQ(basis[0]["weights"], (json{0.5, 0.5}));
    EXPECT_EQ(basis[0]["tangentWeights"], (json{0.125, -0.125}));
}

TEST(CommandLine, prefersANameToAnIndex) {
    EXPECT_EQ(evaluated({"--curve", "0", "--t", "0"})[0]["position"], (json{1.0, 2.0}));
    EXPECT_EQ(evaluated({"--curve", "1", "--t", "0"})[0]["position"], (json{1.0, 2.0}));
    EXPECT_EQ(evaluated({"--t", "0"})[0]["position"], (json{-3.5, 0.25}));
}

TEST(CommandLine, samples) {
    const auto csv = run({"sample", "-", "--per-segment", "2"}, sample);
    EXPECT_EQ(csv.exitCode(), 0) << csv.err;
    EXPECT_EQ(std::ranges::count(csv.out, '\n'), 1 + 2 * 3 + 1);
    EXPECT_TRUE(csv.out.starts_with("t,length,time,x,y,")) << csv.out;
    const auto even =
        run({"sample", "-", "--curve", "0", "--count", "3", "--spacing", "length"}, sample);
    EXPECT_EQ(std::ranges::count(even.out, '\n'), 1 + 3);
    EXPECT_NE(even.out.find("\n2,6,1,4,7,0,1,0\n"), std::string::npos) << even.out;
}

/// A loop, as a plane curve has one: it crosses itself once and does not turn the other way.
TEST(CommandLine, measuresWhereACurveCrossesItself) {
    const auto ran = run({"measure", "-"}, curves(R"({"family": "bezier",
        "points": [[1, 1], [9, 7], [-3, 7], [5, 1]]})"));
    ASSERT_EQ(ran.exitCode(), 0) << ran.err;
    const auto measured = json::parse(ran.out);
    ASSERT_EQ(measured["selfIntersections"].size(), 1u);
    const auto& crossing = measured["selfIntersections"][0];
    EXPECT_NEAR(crossing["position"][0].get<double>(), 3, 1e-12);
    EXPECT_NEAR(crossing["a"]["u"].get<double>() + crossing["b"]["u"].get<double>(), 1, 1e-12);
    EXPECT_EQ(measured["selfIntersectionsComplete"], true);
    EXPECT_TRUE(measured["inflections"].empty());
    EXPECT_TRUE(measured["cusps"].empty());
}

TEST(CommandLine, measures) {
    const auto ran = run({"measure", "-", "--curve", "0"}, sample); // (1, 2), (4, 6), (4, 7)
    ASSERT_EQ(ran.exitCode(), 0) << ran.err;
    const auto measured = json::parse(ran.out);
    EXPECT_EQ(measured["length"], 6);
    EXPECT_EQ(measured["bounds"]["low"], (json{1, 2}));
    EXPECT_EQ(measured["bounds"]["high"], (json{4, 7}));
    ASSERT_EQ(measured["joints"].size(), 1u);
    const auto& joint = measured["joints"][0];
    EXPECT_EQ(joint["t"], 1);
    EXPECT_EQ(joint["c"], 0);
    EXPECT_EQ(joint["g"], 0);
    EXPECT_EQ(joint["residuals"]["position"], 0);
    EXPECT_NEAR(joint["residuals"]["direction"].get<double>(), std::atan2(3.0, 4.0), 1e-15);
    EXPECT_NEAR(joint["residuals"]["speedRatio"].get<double>(), 0.2, 1e-15);
}

TEST(CommandLine, convertsOrSaysWhyNot) {
    const auto folder =
        fs::temp_directory_path() / ("splineloft-convert-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const auto out = (folder / "out.json").string();
    const auto ran = run({"convert", "-", "--family", "bezier-spline", "-o", out}, curves(path));
    ASSERT_EQ(ran.exitCode(), 0) << ran.err;
    const auto converted = json::parse(*readFile(out));
    EXPECT_EQ(converted["curves"][0]["family"], "bezier-spline");
    EXPECT_EQ(converted["curves"][0]["points"].size(), 10u);
    const auto before = run({"eval", "-", "--segment", "1", "--u", "0.25"}, curves(path));
    const auto after = run({"eval", out, "--segment", "1", "--u", "0.25"});
    EXPECT_EQ(json::parse(before.out)[0]["position"], json::parse(after.out)[0]["position"]);

    const auto refused = run({"convert", "-", "--family", "duff", "-o", out}, curves(path));
    EXPECT_EQ(refused.exitCode(), 1);
    EXPECT_NE(refused.err.find("/curves/0/family"), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("right would be: bezier-spline"), std::string::npos) << refused.err;
    EXPECT_EQ(run({"convert", "-", "-o", "out.svg"}, curves(path)).exitCode(), 2);
    fs::remove_all(folder);
}

TEST(CommandLine, samplesIntoFiles) {
    const auto folder =
        fs::temp_directory_path() / ("splineloft-cli-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const auto csv = (folder / "out.csv").string();
    const auto samplesJson = (folder / "out.JSON").string();
    const auto printed = run({"sample", "-", "--count", "5"}, sample);
    EXPECT_EQ(run({"sample", "-", "--count", "5", "-o", csv}, sample).out, "");
    EXPECT_EQ(run({"sample", "-", "--count", "5", "-o", samplesJson}, sample).exitCode(), 0);
    EXPECT_EQ(*readFile(csv), printed.out);
    EXPECT_EQ(json::parse(*readFile(samplesJson))["samples"].size(), 5u);
    const auto missing = run({"sample", "-", "--count", "5", "-o", folder / "no/out.csv"}, sample);
    EXPECT_EQ(missing.exitCode(), 1);
    EXPECT_NE(missing.err.find("folder does not exist"), std::string::npos) << missing.err;
    fs::remove_all(folder);
}

TEST(CommandLine, checksEveryFile) {
    const auto folder =
        fs::temp_directory_path() / ("splineloft-check-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const auto good = (folder / "good.json").string();
    const auto one = (folder / "one.json").string();
    const auto bad = (folder / "bad.json").string();
    std::ofstream(good) << sample;
    std::ofstream(one) << curves(R"({"family": "linear", "points": [[1, 2]]})");
    std::ofstream(bad) << curves(R"({"family": "linear", "points": [[1, 2]], "knots": []})");
    const auto ran = run({"check", good, bad, one, (folder / "missing.json").string()});
    EXPECT_EQ(ran.exitCode(), 1);
    EXPECT_EQ(ran.out, good + ": ok (4 curves, 13 points)\n" + one + ": ok (1 curve, 1 point)\n");
    EXPECT_EQ(std::ranges::count(ran.err, '\n'), 2) << ran.err;
    EXPECT_TRUE(ran.err.starts_with(bad + ": /curves/0/knots: the family linear takes no knots"))
        << ran.err;
    EXPECT_EQ(run({"check", good, one}).exitCode(), 0);
    EXPECT_EQ(run({"check", "-"}, sample).out, "standard input: ok (4 curves, 13 points)\n");
    fs::remove_all(folder);
}

TEST(CommandLine, listsFamilies) {
    const auto table = run({"families"});
    EXPECT_EQ(table.exitCode(), 0);
    EXPECT_NE(table.out.find("bezier-spline"), std::string::npos);
    const auto list = json::parse(run({"families", "--json"}).out);
    const auto beta = std::ranges::find_if(list, [](const json& f) { return f["id"] == "beta"; });
    ASSERT_NE(beta, list.end());
    EXPECT_EQ((*beta)["parameters"][0]["key"], "bias");
    EXPECT_EQ((*beta)["parameters"][0]["range"], (json{0.001, 1000}));
    EXPECT_EQ((*beta)["parameters"][0]["scale"], "ratio");
    EXPECT_EQ((*beta)["ends"][0], "doubled");
}

TEST(CommandLine, helps) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--help"},
                                                      {"eval", "--help"},
                                                      {"sample", "-h"},
                                                      {"--version"}}) {
        const auto ran = run(arguments);
        EXPECT_EQ(ran.exitCode(), 0) << arguments[0];
        EXPECT_FALSE(ran.out.empty());
        EXPECT_EQ(ran.err, "");
    }
    EXPECT_TRUE(run({"--version"}).out.starts_with("splineloft "));
}

TEST(CommandLine, opensTheEditor) {
    EXPECT_TRUE(std::get<OpenEditor>(run({}).command).files.empty());
    EXPECT_EQ(std::get<OpenEditor>(run({"a.json", "b/c.json"}).command).files,
              (std::vector<std::string>{"a.json", "b/c.json"}));
    EXPECT_EQ(std::get<OpenEditor>(run({"./eval"}).command).files,
              std::vector<std::string>{"./eval"});
    EXPECT_EQ(std::get<OpenEditor>(run({"--", "-odd.json"}).command).files,
              std::vector<std::string>{"-odd.json"});
}

TEST(CommandLine, asksForScreenshots) {
    const auto plain = std::get<DrawScreenshot>(run({"screenshot", "-o", "a.png"}).command);
    EXPECT_FALSE(plain.file);
    EXPECT_EQ(plain.output, "a.png");
    EXPECT_EQ(plain.width, 1280);
    EXPECT_EQ(plain.height, 800);
    EXPECT_EQ(plain.theme, "dark");
    const auto full = std::get<DrawScreenshot>(
        run({"screenshot", "a.json", "-o", "b.PNG", "--size", "640x480", "--theme", "light",
             "--show", "basis,comb", "--scale", "1.5", "--plot", "speed", "--pace", "parameter"})
            .command);
    EXPECT_EQ(full.file, "a.json");
    EXPECT_EQ(full.width, 640);
    EXPECT_EQ(full.height, 480);
    EXPECT_EQ(full.theme, "light");
    EXPECT_EQ(full.scale, 1.5);
    EXPECT_EQ(full.show, (std::vector<std::string>{"basis", "comb"}));
    EXPECT_EQ(plain.plot, "basis");
    EXPECT_EQ(plain.pace, "length");
    EXPECT_EQ(full.plot, "speed");
    EXPECT_EQ(full.pace, "parameter");
}

} // namespace
} // namespace splineloft
