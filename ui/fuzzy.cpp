#include "ui/fuzzy.h"

#include <algorithm>
#include <limits>

namespace splineloft::ui {
namespace {

// What a matched letter is worth, in letters: one at the start of a word nearly as much as one that
// follows the letter matched before, for initials are as good a memory as a beginning.
constexpr double plainLetter = 1;
constexpr double wordStart = 6;
constexpr double consecutive = 7;
constexpr double skippedLetter = -0.05;

constexpr double impossible = -std::numeric_limits<double>::infinity();

/// A letter without its case and accent, and where its bytes begin.
struct Letter {
    char32_t sign = 0;
    std::size_t at = 0;
    bool startsWord = false;
};

/// Lower case, and without the accents of Latin-1.
char32_t folded(char32_t sign) {
    constexpr std::string_view plain = "aaaaaaaceeeeiiiidnooooo/ouuuuypy"; // for U+00E0 .. U+00FF
    if (sign >= 'A' && sign <= 'Z') {
        return sign - 'A' + 'a';
    }
    if (sign >= 0xC0 && sign <= 0xFF) {
        return static_cast<char32_t>(plain[(sign - 0xC0) % plain.size()]);
    }
    return sign;
}

bool isPartOfWord(char32_t sign) {
    return (sign >= 'a' && sign <= 'z') || (sign >= '0' && sign <= '9') || sign > 0x7f;
}

/// The letters of a text in UTF-8.
std::vector<Letter> lettersOf(std::string_view text) {
    std::vector<Letter> letters;
    bool inWord = false;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
        char32_t sign = length == 1 ? lead : lead & (0x7fU >> length);
        for (std::size_t k = 1; k < length && i + k < text.size(); ++k) {
            sign = sign << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3fU);
        }
        sign = folded(sign);
        letters.push_back({sign, i, isPartOfWord(sign) && !inWord});
        inWord = isPartOfWord(sign);
        i += length;
    }
    return letters;
}

/// The best match of one word. best[k][i]: the score of its first k + 1 letters where the last of
/// them is the text's i-th; from[k][i]: where the one before it was.
class WordMatch {
  public:
    WordMatch(const std::vector<Letter>& word, const std::vector<Letter>& text)
        : text_(text), best_(word.size(), std::vector<double>(text.size(), impossible)),
          from_(word.size(), std::vector<std::size_t>(text.size(), 0)) {
        for (std::size_t k = 0; k < word.size(); ++k) {
            for (std::size_t i = k; i < text.size(); ++i) {
                if (text[i].sign == word[k].sign) {
                    k == 0 ? begin(i) : extend(k, i);
                }
            }
        }
    }

    /// Adds the match to what other words gave; false where there is none.
    bool addTo(FuzzyMatch& match) const {
        const auto& last = best_.back();
        auto at = static_cast<std::size_t>(std::ranges::max_element(last) - last.begin());
        if (text_.empty() || last[at] == impossible) {
            return false;
        }
        match.score += last[at];
        for (std::size_t k = best_.size(); k-- > 0;) {
            match.letters.push_back(text_[at].at);
            at = from_[k][at];
        }
        return true;
    }

  private:
    double worth(std::size_t i) const {
        return plainLetter + (text_[i].startsWord ? wordStart : 0);
    }

    void begin(std::size_t i) { best_[0][i] = worth(i) + skippedLetter * static_cast<double>(i); }

    void extend(std::size_t k, std::size_t i) {
        for (std::size_t j = k - 1; j < i; ++j) {
            const auto skipped = static_cast<double>(i - j - 1);
            const double step =
                j + 1 == i ? plainLetter + consecutive : worth(i) + skippedLetter * skipped;
            if (best_[k - 1][j] + step > best_[k][i]) {
                best_[k][i] = best_[k - 1][j] + step;
                from_[k][i] = j;
            }
        }
    }

    const std::vector<Letter>& text_;
    std::vector<std::vector<double>> best_;
    std::vector<std::vector<std::size_t>> from_;
};

} // namespace

std::optional<FuzzyMatch> fuzzyMatch(std::string_view pattern, std::string_view text) {
    const auto letters = lettersOf(text);
    FuzzyMatch match;
    while (true) {
        pattern.remove_prefix(std::min(pattern.find_first_not_of(' '), pattern.size()));
        if (pattern.empty()) {
            break;
        }
        const auto end = std::min(pattern.find(' '), pattern.size());
        const auto word = lettersOf(pattern.substr(0, end));
        if (!WordMatch(word, letters).addTo(match)) {
            return std::nullopt;
        }
        pattern.remove_prefix(end);
    }
    std::ranges::sort(match.letters);
    match.letters.erase(std::unique(match.letters.begin(), match.letters.end()),
                        match.letters.end());
    return match;
}

} // namespace splineloft::ui
