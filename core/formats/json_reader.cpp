// From JSON text to the tape, by way of the JSON library's SAX interface.
#include "core/formats/json_tape.h"

#include "core/formats/json_text.h"
#include "core/formats/numbers.h"
#include "core/spline/problem.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <set>

namespace splineloft {
namespace {

constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// Line and column, both from 1, of byte `at`; columns count characters.
std::string lineAndColumn(std::string_view text, std::size_t at) {
    const auto before = text.substr(0, at);
    const auto line = 1 + std::ranges::count(before, '\n');
    const auto lineStart = before.rfind('\n') + 1; // none found, npos, gives 0
    const auto beginsCharacter = [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    };
    const auto column = 1 + std::ranges::count_if(before.substr(lineStart), beginsCharacter);
    return std::to_string(line) + ":" + std::to_string(column);
}

/// The library's words for a syntax error, e.g. "... while parsing value - unexpected '}'; last
/// read:
/// '[1,}'; expected '[', '{', or a literal", taken apart.
Refusal syntaxRefusal(std::string place, std::string_view words) {
    if (const auto dash = words.find(" - "); dash != words.npos) {
        words.remove_prefix(dash + 3);
    }
    Refusal refusal{"", std::move(place), "", "JSON as in RFC 8259"};
    constexpr std::string_view expected = "; expected ";
    if (const auto at = words.rfind(expected); at != words.npos) {
        refusal.remedy = words.substr(at + expected.size());
        words = words.substr(0, at);
    }
    refusal.what = words.substr(0, words.find("; last read"));
    return refusal;
}

/// The library hands on a number with its locale's decimal point: this is how the text spelled it.
std::string asSpelled(std::string number) {
    constexpr std::string_view withoutPoint = "0123456789+-eE";
    std::ranges::replace_if(
        number, [&](char c) { return withoutPoint.find(c) == withoutPoint.npos; }, '.');
    return number;
}

} // namespace

/// Receives the values of a text one by one. The JSON library names these functions; each answers
/// whether to go on.
class JsonTapeWriter {
  public:
    JsonTapeWriter(std::string_view source, std::optional<KeptMember> kept)
        : source_(source), kept_(kept) {}

    bool null() {
        return keeping() ? keep([](JsonText& text) { text.null(); })
                         : put(JsonCell(JsonKind::null));
    }
    bool boolean(bool value) {
        if (keeping()) {
            return keep([&](JsonText& text) { text.boolean(value); });
        }
        JsonCell cell(JsonKind::boolean);
        cell.boolean = value;
        return put(cell);
    }
    bool number_integer(std::int64_t value) {
        return number(std::to_string(value), static_cast<double>(value));
    }
    bool number_unsigned(std::uint64_t value) {
        return number(std::to_string(value), static_cast<double>(value));
    }
    bool number_float(double value, const std::string& token) {
        const auto spelled = asSpelled(token);
        if (keeping() && spelled.find_first_of(".eE") == spelled.npos) {
            arrive();
            return refuse(pointer(), "is an integer of more than 64 bits, which would be rounded",
                          "an integer up to 18446744073709551615, or a string");
        }
        return number(spelled, numberFrom(spelled).value_or(value));
    }
    bool string(const std::string& value) {
        return keeping() ? keep([&](JsonText& text) { text.text(value); }) : put(textCell(value));
    }
    bool binary(const nlohmann::json::binary_t&) { return false; } // JSON text has none

    bool start_object(std::size_t) { return begin(JsonKind::object); }
    bool start_array(std::size_t) { return begin(JsonKind::array); }
    bool end_object() { return end(); }
    bool end_array() { return end(); }

    bool key(const std::string& name) {
        auto& level = levels_.back();
        level.key = name;
        if (!level.keys.insert(name).second) {
            return refuse(pointer(), "stands twice in its object", "each key once");
        }
        if (levels_.size() == keptLevel_) {
            excepted_ = kept_ && name == kept_->exception;
        }
        if (keeping()) {
            keptText_.key(name);
        } else {
            tape_.cells_.push_back(textCell(name));
        }
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::json::exception& error) {
        constexpr int numberOverflow = 406;
        if (error.id == numberOverflow) {
            arrive();
            return refuse(pointer(), "is too large a number: " + inQuotes(asSpelled(token)),
                          "a number that fits into 64 bits");
        }
        refusal_ =
            syntaxRefusal(lineAndColumn(source_, position == 0 ? 0 : position - 1), error.what());
        return false;
    }

    Result<JsonTape> result() && {
        if (refusal_) {
            return *refusal_;
        }
        tape_.keptText_ = keptText_.str();
        return std::move(tape_);
    }

  private:
    /// One level of nesting.
    struct Level {
        bool isObject;
        std::size_t cell;      ///< on the tape, of the array or object itself; or nowhere
        std::size_t count = 0; ///< entries that have begun
        std::string key = {};  ///< the latest
        std::set<std::string> keys = {};
    };

    bool keeping() const { return keptLevel_ != 0 && !excepted_; }
    /// Whether the value that begins now is the one to be kept as text.
    bool isKept() const {
        if (!kept_) {
            return levels_.empty();
        }
        return levels_.size() == 1 && levels_[0].isObject && levels_[0].key == kept_->key;
    }

    void arrive() {
        if (!levels_.empty()) {
            ++levels_.back().count;
        }
    }
    bool put(const JsonCell& cell) {
        arrive();
        tape_.cells_.push_back(cell);
        return true;
    }
    template <class Write> bool keep(Write write) {
        arrive();
        write(keptText_);
        return true;
    }
    bool number(const std::string& spelled, double value) {
        if (keeping()) {
            return keep([&](JsonText& text) { text.raw(spelled); });
        }
        JsonCell cell(JsonKind::number);
        cell.number = value;
        return put(cell);
    }
    JsonCell textCell(std::string_view value) {
        JsonCell cell(JsonKind::text);
        cell.text = {static_cast<std::uint32_t>(tape_.letters_.size()),
                     static_cast<std::uint32_t>(value.size())};
        tape_.letters_ += value;
        return cell;
    }

    bool begin(JsonKind kind) {
        const bool isObject = kind == JsonKind::object;
        const bool keptNow = isObject && !keeping() && isKept();
        Level level{isObject, keeping() ? nowhere : tape_.cells_.size()};
        if (keeping()) {
            arrive();
        } else {
            put(JsonCell(kind));
        }
        if (levels_.size() == deepestNesting) {
            return refuse(pointer(), "is nested too deeply",
                          "at most " + std::to_string(deepestNesting) + " levels");
        }
        levels_.push_back(std::move(level));
        if (keptNow) {
            keptLevel_ = levels_.size();
        }
        if (keeping()) {
            isObject ? keptText_.beginObject() : keptText_.beginArray(Flow::asFirst);
        }
        return true;
    }
    bool end() {
        if (levels_.size() == keptLevel_) {
            excepted_ = false;
        }
        if (keeping()) {
            keptText_.end();
            keptLevel_ = levels_.size() == keptLevel_ ? 0 : keptLevel_;
        }
        if (const auto cell = levels_.back().cell; cell != nowhere) {
            tape_.cells_[cell].extent = static_cast<std::uint32_t>(tape_.cells_.size() - cell);
        }
        levels_.pop_back();
        return true;
    }

    /// Where the latest value, or key, stands.
    std::string pointer() const {
        std::string place;
        for (const auto& level : levels_) {
            place += level.isObject ? pointerToken(level.key) : pointerToken(level.count - 1);
        }
        return place;
    }
    bool refuse(std::string place, std::string what, std::string remedy) {
        refusal_ = Refusal{"", std::move(place), std::move(what), std::move(remedy)};
        return false;
    }

    std::string_view source_;
    std::optional<KeptMember> kept_; ///< none: the whole
    std::size_t keptLevel_ = 0;      ///< number of levels down to the kept object, while in it
    bool excepted_ = false;          ///< while in what is excepted from being kept
    std::vector<Level> levels_;
    JsonTape tape_;
    JsonText keptText_;
    std::optional<Refusal> refusal_;
};

namespace {

Result<JsonTape> read(std::string_view text, std::optional<KeptMember> kept) {
    if (text.size() > largestFile) {
        return Refusal{"", "", "has " + std::to_string(text.size()) + " bytes",
                       "at most 64 MB: " + std::to_string(largestFile) + " bytes"};
    }
    if (const auto nul = text.find('\0'); nul != text.npos) {
        return Refusal{"", lineAndColumn(text, nul), "is a NUL byte", "text only"};
    }
    if (text.empty()) { // the library words this in its own way, by version
        return Refusal{"", "1:1", "unexpected end of input", "'[', '{', or a literal"};
    }
    JsonTapeWriter writer(text, kept);
    nlohmann::json::sax_parse(text.begin(), text.end(), &writer);
    return std::move(writer).result();
}

} // namespace

Result<JsonTape> readJson(std::string_view text, const KeptMember& kept) {
    return read(text, kept);
}

Result<std::string> tidyObject(std::string_view text) {
    auto tape = read(text, std::nullopt);
    if (!tape) {
        return tape.refusal();
    }
    if (tape->root().kind() != JsonKind::object) {
        return Refusal{"", "", std::string(describe(tape->root().kind())), "an object"};
    }
    return tape->keptText();
}

} // namespace splineloft
