// The small parts of all formats: numbers, messages, JSON text.
#include "core/formats/document_json.h"
#include "core/formats/json_text.h"
#include "core/formats/numbers.h"
#include "tests/unit/json_documents.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

namespace splineloft {
namespace {

TEST(Shortest, isExactAndPlain) {
    const std::vector<std::pair<double, std::string>> expected = {
        {0, "0"},
        {-0.0, "-0.0"},
        {1, "1"},
        {-2.5, "-2.5"},
        {0.1, "0.1"},
        {100000, "100000"},
        {1e9, "1000000000"},
        {1e22, "1e+22"},
        {5e-324, "5e-324"},
        {1e-5, "0.00001"},
        {1e-6, "1e-06"},
        {1.0 / 3, "0.3333333333333333"},
        {1e15, "1e+15"},
        {999999999999999, "999999999999999"}};
    for (const auto& [value, text] : expected) {
        EXPECT_EQ(shortest(value), text);
    }
}

TEST(Shortest, readsBackToTheBit) {
    std::mt19937_64 random(11);
    for (int i = 0; i < 100'000; ++i) {
        const auto value = std::bit_cast<double>(random());
        if (std::isfinite(value)) {
            const auto text = shortest(value);
            ASSERT_EQ(numberFrom(text), value) << text;
            ASSERT_LE(text.size(), 25u) << text;
        }
    }
}

TEST(NumberFrom, takesWholeDecimalNumbersOnly) {
    for (const auto* text :
         {"", " 1", "1 ", "1x", "0x10", "inf", "nan", "1e999", "+1", "1,5", "--1"}) {
        EXPECT_FALSE(numberFrom(text)) << text;
    }
    EXPECT_EQ(numberFrom("-1.5e2"), -150);
    EXPECT_FALSE(wholeNumberFrom("1.0"));
    EXPECT_FALSE(wholeNumberFrom("99999999999999999999"));
    EXPECT_EQ(wholeNumberFrom("-12"), -12);
}

TEST(Refusal, isOneLine) {
    EXPECT_EQ((Refusal{"a.json", "/curves/0", "is null", "an object"}.message()),
              "a.json: /curves/0: is null; right would be: an object");
    EXPECT_EQ((Refusal{"", "", "the disk is full", ""}.message()), "the disk is full");
    EXPECT_EQ((Refusal{"a\nb\x1b[31m", "", "is bad", ""}.message()),
              "a\\u000ab\\u001b[31m: is bad");
}

TEST(Refusal, staysShortWhateverTheFileSays) {
    const auto document = readDocument(curveWith("\"" + std::string(1'000'000, 'k') + "\": 1"));
    ASSERT_FALSE(document);
    EXPECT_LT(document.refusal().message().size(), 500u);
    EXPECT_EQ(inQuotes(repeated("ä", 100)), "\"" + repeated("ä", 24) + "…\"");
}

TEST(JsonText, refusesWhatJsonCannotSay) {
    JsonText json;
    EXPECT_THROW(json.number(std::nan("")), std::invalid_argument);
    EXPECT_THROW(json.number(HUGE_VAL), std::invalid_argument);
    json.beginArray(Flow::inLine);
    json.numberOrNull(HUGE_VAL);
    json.numberOrNull(std::nullopt);
    json.numberOrNull(1.5);
    json.end();
    EXPECT_EQ(json.str(), "[null, null, 1.5]");
}

} // namespace
} // namespace splineloft
