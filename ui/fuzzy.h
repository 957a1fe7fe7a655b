// Matching a text by a few of its letters, as palettes of commands do.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace splineloft::ui {

/// Where a pattern was found in a text.
struct FuzzyMatch {
    double score = 0;                 ///< higher is better
    std::vector<std::size_t> letters; ///< bytes at which the matched letters begin, ascending
};

/// Matches when each word of the pattern is a subsequence of the text, letters of either case and
/// with or without accents. Letters that begin words, and that follow one another, score more;
/// of all ways to match, the best counts. An empty pattern matches everything, with score 0.
std::optional<FuzzyMatch> fuzzyMatch(std::string_view pattern, std::string_view text);

} // namespace splineloft::ui
