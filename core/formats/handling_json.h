// What a document's file keeps about how its curves are handled, and not about what they are: their
// looks, and the modes of their handles. It stands in the extras, so that the format of curves need
// not know of it:
//
//     "extras": {"splineloft": {"curves": [{"visible": false, "locked": true, "colour": 3,
//                                           "handles": {"3": "corner"}}, ...]}}
//
// with an entry for each curve, up to the last that has anything to say; all that is as usual is
// left out.
#pragma once

#include "core/document/document.h"
#include "core/formats/value_reader.h"

#include <string>
#include <string_view>

namespace splineloft {

/// The key within the extras.
inline constexpr std::string_view ownExtrasKey = "splineloft";

/// The JSON text that stands under the key; empty where all is as usual.
std::string handlingAsJson(const Document& document);

/// Reads it into the curves of the document, which have been read already.
void readHandling(const JsonValue& value, const JsonPlace& place, ValueReader& reader,
                  Document& document);

} // namespace splineloft
