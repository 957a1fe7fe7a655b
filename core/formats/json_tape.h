// JSON read strictly: the values of a text, one after another as on a tape, in the order in which
// they stand there.
//
// What JSON readers often let pass is refused here, with its place: keys that stand twice, bytes
// after the end or after a NUL, numbers too large, nesting without end. Nothing recurses, and a
// value takes 16 bytes, so a hostile text costs no more than a few times its size.
#pragma once

#include "core/formats/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace splineloft {

/// Largest text that is read, in bytes.
inline constexpr std::size_t largestFile = std::size_t{64} * 1024 * 1024;
/// Objects and arrays may stand in each other this deep, the outermost counted.
inline constexpr std::size_t deepestNesting = 64;

/// What a JSON value is.
enum class JsonKind : std::uint8_t { null, boolean, number, text, array, object };

/// In words, e.g. "is a number".
std::string_view describe(JsonKind kind);

/// A place within a JSON text, spelled out only when it is asked for. It refers to the place that
/// it lies in, which must outlive it.
class JsonPlace {
  public:
    JsonPlace() = default; ///< the whole text
    JsonPlace(const JsonPlace& within, std::string_view key) : within_(&within), key_(key) {}
    JsonPlace(const JsonPlace& within, std::size_t index) : within_(&within), index_(index) {}

    /// As JSON pointer (RFC 6901), e.g. "/curves/0/points/3". Very long keys are shortened.
    std::string pointer() const;

  private:
    const JsonPlace* within_ = nullptr;
    std::string_view key_;
    std::size_t index_ = notAnIndex;

    static constexpr std::size_t notAnIndex = static_cast<std::size_t>(-1);
};

/// One value on the tape. `extent` leads to the value after it and all that it contains.
struct JsonCell {
    explicit JsonCell(JsonKind what) : kind(what) {}

    JsonKind kind;
    std::uint32_t extent = 1;
    union {
        double number = 0;
        bool boolean;
        struct {
            std::uint32_t start, length;
        } text; ///< among the tape's letters
    };
};

class JsonTape;

/// A value on a tape, which must outlive it.
class JsonValue {
  public:
    JsonValue(const JsonTape& tape, std::size_t at) : tape_(&tape), at_(at) {}

    JsonKind kind() const { return cell().kind; }
    double number() const { return cell().number; }
    bool boolean() const { return cell().boolean; }
    std::string_view text() const;

    /// Entries of an array, or keys and values of an object in turn: for (auto v = value.inside();
    /// !value.ends(v); v = v.next()).
    JsonValue inside() const { return {*tape_, at_ + 1}; }
    JsonValue next() const { return {*tape_, at_ + cell().extent}; }
    bool ends(const JsonValue& entry) const { return entry.at_ == at_ + cell().extent; }

  private:
    const JsonCell& cell() const;

    const JsonTape* tape_;
    std::size_t at_;
};

/// Calls `visit(key, value)` for every member of an object, in their order.
template <class Visit> void forEachMember(const JsonValue& object, Visit visit) {
    for (auto entry = object.inside(); !object.ends(entry);) {
        const auto value = entry.next();
        visit(entry.text(), value);
        entry = value.next();
    }
}

/// Calls `visit(value)` for every entry of an array, in their order.
template <class Visit> void forEachEntry(const JsonValue& array, Visit visit) {
    for (auto entry = array.inside(); !array.ends(entry); entry = entry.next()) {
        visit(entry);
    }
}

/// All values of a text.
class JsonTape {
  public:
    JsonValue root() const { return {*this, 0}; }
    /// The member of the outermost object that was to be kept as text; empty where it is no object
    /// or does not exist.
    const std::string& keptText() const { return keptText_; }

  private:
    friend class JsonValue;
    friend class JsonTapeWriter;

    std::vector<JsonCell> cells_;
    std::string letters_;
    std::string keptText_;
};

/// The member of that key; nothing where `object` has none, or is no object.
std::optional<JsonValue> memberOf(const JsonValue& object, std::string_view key);

/// Which member of the outermost object is kept as text.
struct KeptMember {
    std::string_view key;
    std::string_view exception; ///< a member of its own that is not
};

/// Reads a text. An object that is the kept member is kept as text, tidied but with every number
/// spelled as it was; on the tape it is empty but for its exception.
Result<JsonTape> readJson(std::string_view text, const KeptMember& kept = {});

/// Tidies the text of one JSON object: our layout, numbers spelled as they were.
Result<std::string> tidyObject(std::string_view text);

} // namespace splineloft
