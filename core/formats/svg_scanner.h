// The letters, numbers and flags of SVG path data, one after the other (SVG 1.1, section 8.3.9).
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace splineloft {

/// Reads a text from its beginning to its end; white space and the commas after numbers are passed
/// over.
class SvgScanner {
  public:
    explicit SvgScanner(std::string_view data) : data_(data) { skipSpace(); }

    bool atEnd() const { return at_ == data_.size(); }
    /// The byte that is read next.
    std::size_t at() const { return at_; }
    bool atNumber() const;

    /// The next character, which must be there.
    char letter();
    /// The next number, where there is one that a double can hold.
    std::optional<double> number();
    /// One digit, 0 or 1, which need not be parted from what follows.
    std::optional<bool> flag();

  private:
    char next() const { return atEnd() ? '\0' : data_[at_]; }
    void skipSpace();
    void skipSeparator();
    std::size_t numberLength() const;

    std::string_view data_;
    std::size_t at_ = 0;
};

} // namespace splineloft
