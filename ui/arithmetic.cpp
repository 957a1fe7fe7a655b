#include "ui/arithmetic.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace splineloft::ui {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr int deepest = 32; // parentheses within parentheses

/// Reads from left to right: a sum of products of factors. What is wrong becomes not-a-number,
/// which every sum and product hands on.
class Reader {
  public:
    explicit Reader(std::string_view text) : rest_(text) {}

    double whole() {
        const double value = sum(0);
        skipSpace();
        return rest_.empty() ? value : nothing;
    }

  private:
    void skipSpace() {
        while (!rest_.empty() && rest_.front() == ' ') {
            rest_.remove_prefix(1);
        }
    }

    bool take(char sign) {
        skipSpace();
        const bool found = !rest_.empty() && rest_.front() == sign;
        rest_.remove_prefix(found ? 1 : 0);
        return found;
    }

    double sum(int depth) {
        double value = product(depth);
        for (;;) {
            if (take('+')) {
                value += product(depth);
            } else if (take('-')) {
                value -= product(depth);
            } else {
                return value;
            }
        }
    }

    double product(int depth) {
        double value = factor(depth);
        for (;;) {
            if (take('*')) {
                value *= factor(depth);
            } else if (take('/')) {
                value /= factor(depth);
            } else {
                return value;
            }
        }
    }

    double factor(int depth) {
        double sign = 1;
        for (bool signs = true; signs;) {
            const bool minus = take('-');
            sign = minus ? -sign : sign;
            signs = minus || take('+');
        }
        if (take('(')) {
            const double value = depth < deepest ? sum(depth + 1) : nothing;
            return take(')') ? sign * value : nothing;
        }
        return sign * number();
    }

    double number() {
        skipSpace();
        const bool begins = !rest_.empty() && (rest_.front() == '.' ||
                                               (rest_.front() >= '0' && rest_.front() <= '9'));
        double value = nothing;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (!begins || error != std::errc()) {
            return nothing;
        }
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    std::string_view rest_;
};

} // namespace

std::optional<double> valueOf(std::string_view expression) {
    std::string plain(expression);
    constexpr std::string_view trueMinus = "−";
    for (auto at = plain.find(trueMinus); at != std::string::npos; at = plain.find(trueMinus)) {
        plain.replace(at, trueMinus.size(), "-");
    }
    const double value = Reader(plain).whole();
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace splineloft::ui
