// JSON text as people like to read and compare it: two spaces for each level, one point a line.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace splineloft {

/// How the entries of an object or array are set.
enum class Flow {
    stacked, ///< one below the other
    inLine,  ///< all on one line, and whatever they contain
    asFirst  ///< stacked if the first entry is an object or array, otherwise in line
};

/// A text as it will be read again once it is written: what is not UTF-8 becomes U+FFFD.
std::string asSaved(std::string_view text);

/// Builds JSON text from the outside in. Every begin needs its end; an object's values each need
/// their key first. Strings are taken for UTF-8; what is not becomes U+FFFD.
class JsonText {
  public:
    void beginObject(Flow flow = Flow::stacked) { begin('}', flow); }
    void beginArray(Flow flow = Flow::stacked) { begin(']', flow); }
    void end();

    void key(std::string_view name);
    void text(std::string_view value);
    /// Throws std::invalid_argument where the value is not finite: JSON has no word for it.
    void number(double value);
    void count(std::size_t value) { raw(std::to_string(value)); }
    void boolean(bool value) { raw(value ? "true" : "false"); }
    void null() { raw("null"); }
    /// A value that is JSON text already. Its lines are moved in to where it stands.
    void raw(std::string_view value);

    /// Numbers as an array on one line.
    void numbers(std::span<const double> values);
    /// Texts as an array on one line.
    void texts(std::span<const std::string> values);
    /// A number where there is a finite one, otherwise null.
    void numberOrNull(const std::optional<double>& value);

    /// What has been built so far.
    const std::string& str() const { return text_; }
    /// The whole, with a line feed at its end.
    std::string finished() && { return std::move(text_) + '\n'; }

  private:
    struct Level {
        char closing;
        Flow flow;
        bool empty = true;
    };

    void begin(char closing, Flow flow);
    void beforeValue(bool isContainer);
    void breakLine() { text_.append(1, '\n').append(2 * levels_.size(), ' '); }

    std::string text_;
    std::vector<Level> levels_;
    bool afterKey_ = false;
};

} // namespace splineloft
