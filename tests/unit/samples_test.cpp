// Samples for other programs: what the columns mean, and that the text can be read back.
#include "core/formats/numbers.h"
#include "core/formats/samples.h"
#include "core/spline/catalog.h"
#include "tests/unit/comma_locale.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace splineloft {
namespace {

Curve wave() {
    Curve curve;
    curve.name = "wave";
    curve.points = Points{{-3.5, 0.25}, {-1, 2}, {2.25, -1.5}, {4, 1}};
    return curve;
}

Curve straight(double length) {
    Curve curve;
    curve.family = "linear";
    curve.ends = Ends::none;
    curve.points = Points{{1, 2}, {1 + length * 0.6, 2 + length * 0.8}};
    return curve;
}

SampledPath sampled(const Curve& curve, const Sampling& sampling) {
    auto path = sampledPath(curve, sampling);
    if (!path) {
        ADD_FAILURE() << path.refusal().message();
        return {};
    }
    return *path;
}

std::vector<std::vector<std::string>> rowsOf(const std::string& csv) {
    std::vector<std::vector<std::string>> rows;
    std::size_t start = 0;
    while (start < csv.size()) {
        const auto end = csv.find('\n', start);
        rows.emplace_back();
        for (auto from = start; from <= end;) {
            const auto to = std::min(csv.find(',', from), end);
            rows.back().push_back(csv.substr(from, to - from));
            from = to + 1;
        }
        start = end + 1;
    }
    return rows;
}

TEST(Samples, csvHasOneHeaderLineAndOneLineASample) {
    const auto rows = rowsOf(samplesAsCsv(sampled(wave(), StepsPerPiece{4})));
    ASSERT_EQ(rows.size(), 1 + 3 * 4 + 1u);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"t", "length", "time", "x", "y", "tangent_x",
                                                 "tangent_y", "curvature"}));
    for (const auto& row : rows) {
        EXPECT_EQ(row.size(), rows[0].size());
    }
    EXPECT_EQ(rows[1][3], "-3.5");
    EXPECT_EQ(rows.back()[0], "3");
    EXPECT_EQ(rows.back()[2], "1");
}

TEST(Samples, csvAndJsonHoldTheExactNumbers) {
    const auto path = sampled(wave(), EvenSamples{23});
    const auto rows = rowsOf(samplesAsCsv(path));
    const auto json = nlohmann::json::parse(samplesAsJson(path));
    ASSERT_EQ(json["samples"].size(), 23u);
    EXPECT_EQ(json["format"], "splineloft-samples");
    EXPECT_EQ(json["curve"], "wave");
    EXPECT_EQ(json["count"], 23);
    EXPECT_EQ(json["length"], path.length);
    EXPECT_EQ(json["spacing"], "parameter");
    for (std::size_t i = 0; i < path.samples.size(); ++i) {
        const auto& sample = path.samples[i];
        const auto& entry = json["samples"][i];
        const std::vector<double> expected = {sample.t,
                                              sample.length,
                                              sample.length / path.length,
                                              sample.position[0],
                                              sample.position[1],
                                              sample.tangent[0],
                                              sample.tangent[1],
                                              sample.curvature.value_or(0)};
        for (std::size_t k = 0; k < expected.size(); ++k) {
            EXPECT_EQ(numberFrom(rows[i + 1][k]), expected[k]) << "sample " << i << " column " << k;
        }
        EXPECT_EQ(entry["t"], expected[0]);
        EXPECT_EQ(entry["length"], expected[1]);
        EXPECT_EQ(entry["time"], expected[2]);
        EXPECT_EQ(entry["position"][1], expected[4]);
        EXPECT_EQ(entry["tangent"][0], expected[5]);
        EXPECT_EQ(entry["curvature"], expected[7]);
    }
}

TEST(Samples, evenInLengthOrTimeAreEven) {
    for (const auto in : {EvenSamples::In::length, EvenSamples::In::time}) {
        const auto path = sampled(wave(), EvenSamples{101, in});
        for (std::size_t i = 0; i < path.samples.size(); ++i) {
            EXPECT_NEAR(path.samples[i].length, path.length * static_cast<double>(i) / 100,
                        1e-12 * path.length);
        }
    }
    EXPECT_EQ(sampled(wave(), EvenSamples{2, EvenSamples::In::time}).spacing, "time");
}

TEST(Samples, lengthOfAStraightLineIsItsLength) {
    const auto path = sampled(straight(5), EvenSamples{5});
    EXPECT_NEAR(path.length, 5, 1e-13);
    EXPECT_NEAR(path.samples[1].length, 1.25, 1e-13);
    EXPECT_NEAR(path.samples[1].tangent[0], 3, 1e-13);
}

TEST(Samples, withoutSpeedThereIsNoCurvature) {
    const auto path = sampled(straight(0), EvenSamples{3});
    EXPECT_EQ(path.length, 0);
    const auto rows = rowsOf(samplesAsCsv(path));
    EXPECT_EQ(rows[1].back(), "");
    EXPECT_EQ(rows[3][2], "0");
    const auto json = nlohmann::json::parse(samplesAsJson(path));
    EXPECT_TRUE(json["samples"][0]["curvature"].is_null());
}

TEST(Samples, namesAreQuotedAndUnique) {
    auto curve = wave();
    curve.coordinates = {"a \"b\", c", "t"};
    const auto csv = samplesAsCsv(sampled(curve, EvenSamples{2}));
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "t,length,time,\"a \"\"b\"\", c\",t_,\"tangent_a \"\"b\"\", c\",tangent_t,curvature");
    curve.coordinates = {"tangent_y", "y"};
    const auto clash = samplesAsCsv(sampled(curve, EvenSamples{2}));
    EXPECT_EQ(clash.substr(0, clash.find('\n')),
              "t,length,time,tangent_y,y,tangent_tangent_y,tangent_y_,curvature");
}

TEST(Samples, workForEveryFamilyAndDimension) {
    for (const auto& family : catalog()) {
        for (const int dimension : {1, 3, 16}) {
            Curve curve;
            curve.family = family.id;
            curve.ends = family.ends.front();
            curve.coordinates.clear();
            curve.points = Points(dimension);
            for (int i = 0; i < 7; ++i) {
                Point point(dimension);
                for (int c = 0; c < dimension; ++c) {
                    point[c] = std::sin(1.7 * i + c) + 3;
                }
                curve.points.append(point);
            }
            for (int c = 0; c < dimension; ++c) {
                curve.coordinates.push_back(std::string(1, static_cast<char>('a' + c)));
            }
            if (family.usesTangents) {
                curve.tangents = curve.points;
            }
            SCOPED_TRACE(std::string(family.id) + " " + std::to_string(dimension));
            const auto path = sampled(curve, EvenSamples{9, EvenSamples::In::length});
            const auto rows = rowsOf(samplesAsCsv(path));
            EXPECT_EQ(rows.size(), 10u);
            EXPECT_EQ(rows[5].size(), 4 + 2 * static_cast<std::size_t>(dimension));
            EXPECT_TRUE(nlohmann::json::accept(samplesAsJson(path)));
        }
    }
}

TEST(Samples, refuseCurvesWithoutPieces) {
    auto curve = wave();
    curve.points = Points{{1, 2}};
    const auto one = sampledPath(curve, EvenSamples{10});
    ASSERT_FALSE(one);
    EXPECT_EQ(one.refusal().place, "/points");
    EXPECT_EQ(one.refusal().what, "the curve has no piece yet: it needs 1 more point");
    curve.ends = Ends::open;
    curve.points = Points(2);
    EXPECT_EQ(sampledPath(curve, EvenSamples{10}).refusal().what,
              "the curve has no piece yet: it needs 4 more points");
}

TEST(Samples, refuseTooFewAndTooMany) {
    for (const Sampling& sampling :
         {Sampling(EvenSamples{0}), Sampling(EvenSamples{1}),
          Sampling(EvenSamples{mostSamples + 1}), Sampling(StepsPerPiece{0}),
          Sampling(StepsPerPiece{mostSamples})}) {
        const auto path = sampledPath(wave(), sampling);
        ASSERT_FALSE(path);
        EXPECT_NE(path.refusal().remedy.find(" to "), std::string::npos);
    }
}

TEST(Samples, doNotFollowTheLocale) {
    const auto path = sampled(wave(), EvenSamples{7});
    const auto csv = samplesAsCsv(path);
    const auto json = samplesAsJson(path);
    const CommaLocale comma;
    SPLINELOFT_NEED_COMMA(comma);
    EXPECT_EQ(samplesAsCsv(path), csv);
    EXPECT_EQ(samplesAsJson(path), json);
}

} // namespace
} // namespace splineloft
