// Any text from the clipboard: curves that can be written, or a refusal in words.
#include "core/formats/clipboard.h"
#include "core/formats/document_json.h"
#include "tests/fuzz/curve_from_bytes.h"

#include <string_view>

using namespace splineloft;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto result = pasted({reinterpret_cast<const char*>(data), size});
    if (!result) {
        fuzz::require(!result.refusal().message().empty(), "a refusal has words");
        return 0;
    }
    fuzz::require(!result->curves.empty(), "what was pasted has a curve");
    Document document;
    document.curves = result->curves;
    const auto again = readDocument(writeDocument(document));
    fuzz::require(static_cast<bool>(again), "what was pasted can be saved and read");
    fuzz::require(again->curves.size() == result->curves.size(), "and is as much");
    return 0;
}
