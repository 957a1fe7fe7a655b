// What the command line can do without a window: each command is a function from what was asked to
// the text of its answer, or to the reason why there is none.
#pragma once

#include "core/document/document.h"
#include "core/formats/result.h"
#include "core/formats/samples.h"

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace splineloft {

/// One curve of a file. "-" is the standard input.
struct CurveChoice {
    std::string file;
    std::optional<std::string>
        curve; ///< its name or its index; the first curve where none is given
};

/// Spots of a curve: at values of u on one segment, or at values of the parameter t.
struct SpotQuery {
    CurveChoice choice;
    std::optional<long long> segment; ///< none: `values` are parameters
    std::vector<double> values;
};

/// The document in a file, or on the standard input where `file` is "-".
Result<Document> openDocument(const std::string& file, std::istream& standardInput);

/// The catalog as a table for people.
std::string familiesAsTable();
/// The catalog as a JSON array.
std::string familiesAsJson();

/// JSON array of {"segment","u","t","position","first","second","curvature"}, one a spot.
/// Derivatives are by u on a segment and by t otherwise; curvature is null where the speed is zero.
Result<std::string> evaluate(const SpotQuery& query, std::istream& standardInput);

/// JSON array of {"t","weights"}, one weight a control point; for families with tangents also
/// "tangentWeights".
Result<std::string> basisAt(const SpotQuery& query, std::istream& standardInput);

/// JSON object of a curve: {"length","bounds":{"low","high"},"joints":[{"t","c","g","residuals"}]}.
/// Residuals are the jumps of position, first and second derivative by t, of direction (radians)
/// and of the curvature vector, and the speed after the joint over that before it.
Result<std::string> measure(const CurveChoice& choice, std::istream& standardInput);

/// The text of a document, with all curves turned into another family where one is named. Refused
/// where a curve has no equal in it.
Result<std::string> convert(const std::string& file, const std::optional<std::string>& family,
                            std::istream& standardInput);

/// The samples of a curve of a file.
Result<SampledPath> sample(const CurveChoice& choice, const Sampling& sampling,
                           std::istream& standardInput);

/// A file's good verdict, e.g. "ships.json: ok (2 curves, 9 points)", or what is wrong with it.
Result<std::string> checkFile(const std::string& file, std::istream& standardInput);

} // namespace splineloft
