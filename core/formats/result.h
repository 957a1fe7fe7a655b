// Outcomes at the edge of the program: a value, or the words that say why there is none.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace splineloft {

/// Why an input was refused or a file could not be written: where, what is wrong, what would be
/// right. Parts that do not apply are empty.
struct Refusal {
    std::string file;
    std::string place; ///< JSON pointer, or line:column
    std::string what;
    std::string remedy;

    /// All of it on one line: "FILE: PLACE: what; right would be: remedy".
    std::string message() const;
    bool operator==(const Refusal&) const = default;
};

/// A value, or the refusal that stands in its place.
template <class T> class [[nodiscard]] Result {
  public:
    Result(T value) : outcome_(std::move(value)) {}
    Result(Refusal refusal) : outcome_(std::move(refusal)) {}

    explicit operator bool() const { return std::holds_alternative<T>(outcome_); }
    /// The value. Throws std::bad_variant_access where there is none.
    T& operator*() & { return std::get<T>(outcome_); }
    const T& operator*() const& { return std::get<T>(outcome_); }
    T&& operator*() && { return std::get<T>(std::move(outcome_)); }
    T* operator->() { return &**this; }
    const T* operator->() const { return &**this; }
    /// Why there is no value. Throws std::bad_variant_access where there is one.
    const Refusal& refusal() const { return std::get<Refusal>(outcome_); }

  private:
    std::variant<T, Refusal> outcome_;
};

/// The value of an action that succeeded and has nothing more to say.
struct Done {
    bool operator==(const Done&) const = default;
};

/// `text` between quotation marks, control characters spelled out, shortened where it is long: fit
/// to stand within a sentence.
std::string inQuotes(std::string_view text);

} // namespace splineloft
