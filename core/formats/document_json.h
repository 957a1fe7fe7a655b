// The document as a JSON file, our own format: read strictly, written so that people can read and
// compare it, and so that reading what was written and writing it again gives the same bytes.
// assets/splineloft.schema.json describes the same format to other programs.
#pragma once

#include "core/document/document.h"
#include "core/formats/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace splineloft {

/// The document that `text` describes, with all defaults filled in; or what is wrong with it, at a
/// JSON pointer where it was JSON and at line:column where it was not. The refusal names no file.
Result<Document> readDocument(std::string_view text);

/// The text of a document, defaults written out; how its curves are handled stands in its extras
/// (handling_json.h). Throws std::invalid_argument where the document has a problem (see
/// `problemOf`), or its extras are not the text of one JSON object without our own key.
std::string writeDocument(const Document& document);

/// The usual names of so many coordinates: x, y, z, w, c4, c5, ...
std::vector<std::string> usualCoordinates(int dimension);

} // namespace splineloft
