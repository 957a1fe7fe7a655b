// The command line refuses, or was wrongly called: one line that says so, and the exit code.
#include "tests/interop/sample_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace splineloft {
namespace {

struct Wrong {
    const char* title;
    std::vector<std::string> arguments;
    int exitCode;
    std::string words; ///< part of the one line on the standard error
};

void PrintTo(const Wrong& wrong, std::ostream* out) {
    *out << wrong.title;
}

class CommandLineRefuses : public testing::TestWithParam<Wrong> {};

TEST_P(CommandLineRefuses, inOneLine) {
    const auto& wrong = GetParam();
    const auto ran = run(wrong.arguments, sample);
    EXPECT_EQ(ran.exitCode(), wrong.exitCode) << ran.out << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_NE(ran.err.find(wrong.words), std::string::npos) << ran.err;
    EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << ran.err;
    EXPECT_TRUE(ran.err.ends_with('\n'));
}

std::vector<Wrong> wrongs() {
    constexpr int refused = 1;
    constexpr int usage = 2;
    return {
        {"segmentTooLarge",
         {"eval", "-", "--segment", "3", "--u", "0"},
         refused,
         "standard input: /curves/0: there is no segment 3; right would be: 0 to 2"},
        {"segmentNegative", {"eval", "-", "--segment", "-1", "--u", "0"}, refused, "0 to 2"},
        {"uTooLarge",
         {"eval", "-", "--segment", "0", "--u", "0,1.5"},
         refused,
         "there is no u = 1.5; right would be: 0 to 1"},
        {"uNegative", {"basis", "-", "--segment", "0", "--u", "-0.1"}, refused, "0 to 1"},
        {"tTooLarge",
         {"eval", "-", "--t", "3.5"},
         refused,
         "there is no t = 3.5; right would be: 0 to 3"},
        {"tNegative", {"basis", "-", "--t", "-1"}, refused, "0 to 3"},
        {"noSuchCurve",
         {"eval", "-", "--curve", "pth", "--t", "0"},
         refused,
         "there is no curve \"pth\"; right would be: one of 0 \"path\", 1 \"0\", 2 \"uneven\", 3"},
        {"noSuchIndex",
         {"sample", "-", "--curve", "4", "--count", "3"},
         refused,
         "one of 0 \"path\""},
        {"tooFewSamples", {"sample", "-", "--count", "1"}, refused, "2 to 2000000"},
        {"tooManySteps", {"sample", "-", "--per-segment", "1000000"}, refused, "1 to 666666"},
        {"noFile", {"eval", "missing.json", "--t", "0"}, refused, "missing.json: does not exist"},
        {"noText", {"check", "/"}, refused, "/: is a folder"},
        {"noSpots", {"eval", "-"}, usage, "give --segment with --u, or --t"},
        {"segmentAlone", {"eval", "-", "--segment", "0"}, usage, "--segment requires --u"},
        {"uAlone", {"eval", "-", "--u", "0"}, usage, "--u requires --segment"},
        {"bothKinds", {"eval", "-", "--t", "0", "--segment", "0", "--u", "0"}, usage, "excludes"},
        {"notANumber", {"eval", "-", "--t", "0,x"}, usage, "\"x\" is not a number"},
        {"noNumber", {"eval", "-", "--t", "0,"}, usage, "\"\" is not a number"},
        {"nan", {"eval", "-", "--t", "nan"}, usage, "\"nan\" is not a number"},
        {"notWhole", {"eval", "-", "--segment", "0.5", "--u", "0"}, usage, "not a whole number"},
        {"noCount", {"sample", "-"}, usage, "give --per-segment or --count"},
        {"bothCounts", {"sample", "-", "--count", "5", "--per-segment", "5"}, usage, "excludes"},
        {"negativeCount", {"sample", "-", "--count", "-5"}, usage, "negative"},
        {"unknownSpacing",
         {"sample", "-", "--count", "5", "--spacing", "even"},
         usage,
         "--spacing"},
        {"unknownOutput", {"sample", "-", "--count", "5", "-o", "a.txt"}, usage, ".csv"},
        {"fileMissing", {"eval"}, usage, "FILE is required"},
        {"nothingToCheck", {"check"}, usage, "FILE is required"},
        {"twoFiles", {"eval", "-", "b.json", "--t", "0"}, usage, "b.json"},
        {"unknownOption", {"families", "--jason"}, usage, "--jason"},
        {"unknownCommand", {"evla", "a.json"}, usage, "neither a command nor a file"},
        {"screenshotWithoutOutput", {"screenshot"}, usage, "-o is required"},
        {"screenshotAsJpeg", {"screenshot", "-o", "a.jpg"}, usage, ".png"},
        {"sizeOfOneSide", {"screenshot", "-o", "a.png", "--size", "640"}, usage, "1280x800"},
        {"sizeTooLarge", {"screenshot", "-o", "a.png", "--size", "640x99999"}, usage, "64 to 8192"},
        {"unknownTheme", {"screenshot", "-o", "a.png", "--theme", "blue"}, usage, "--theme"},
        {"unknownPlot", {"screenshot", "-o", "a.png", "--plot", "jerk"}, usage, "--plot"},
        {"unknownPace", {"screenshot", "-o", "a.png", "--pace", "jerk"}, usage, "--pace"},
        {"scaleTooLarge", {"screenshot", "-o", "a.png", "--scale", "9"}, usage, "0.5 to 4"},
    };
}

INSTANTIATE_TEST_SUITE_P(Each, CommandLineRefuses, testing::ValuesIn(wrongs()),
                         [](const auto& each) { return std::string(each.param.title); });

TEST(CommandLine, refusesDocumentsWithoutPieces) {
    const auto none = run({"eval", "-", "--t", "0"}, curves(""));
    EXPECT_EQ(none.exitCode(), 1);
    EXPECT_NE(none.err.find("no curve"), std::string::npos) << none.err;
    const auto point = curves(R"({"family": "cardinal", "ends": "open", "points": [[1, 2]]})");
    for (const std::string command : {"eval", "basis"}) {
        const auto ran = run({command, "-", "--t", "0"}, point);
        EXPECT_EQ(ran.exitCode(), 1);
        EXPECT_EQ(ran.err,
                  "standard input: /curves/0/points: the curve has no piece yet: it needs 3 "
                  "more points; right would be: at least 4 points\n");
    }
}

TEST(CommandLine, refusesDerivativesThatAreNoNumbers) {
    const auto curve = curves(R"({"family": "b-spline", "parameters": {"degree": 2},
        "points": [[1, 0], [1, 3], [2, 2], [4, 1]],
        "knots": [0, 0, 0, 5e-161, 1e-160, 1e-160, 1e-160]})");
    const auto byT = run({"eval", "-", "--t", "5e-161"}, curve);
    EXPECT_EQ(byT.exitCode(), 1);
    EXPECT_EQ(byT.out, "");
    EXPECT_EQ(byT.err,
              "standard input: /curves/0: the derivatives by t at t = 5e-161 are too large for "
              "numbers; right would be: --segment 1 --u 0, for derivatives by u; or a wider range "
              "of t\n");
    EXPECT_EQ(run({"eval", "-", "--segment", "1", "--u", "0"}, curve).exitCode(), 0);
}

TEST(CommandLine, refusesAmbiguousNames) {
    const auto ran = run({"eval", "-", "--curve", "path", "--t", "0"}, curves(path + "," + path));
    EXPECT_EQ(ran.exitCode(), 1);
    EXPECT_NE(ran.err.find("several curves"), std::string::npos) << ran.err;
}

TEST(CommandLine, noticesThatItCannotPrint) {
    std::istringstream in(sample);
    std::ofstream full("/dev/full");
    std::ostringstream err;
    const char* argv[] = {"splineloft", "families"};
    const auto command = runCommandLine(2, argv, {in, full, err});
    EXPECT_EQ(std::get<Finished>(command).exitCode, 1);
    EXPECT_NE(err.str().find("standard output"), std::string::npos) << err.str();
}

} // namespace
} // namespace splineloft
