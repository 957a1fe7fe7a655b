// Any text as a document: read and written back, or a refusal in words.
#include "core/formats/document_json.h"
#include "tests/fuzz/curve_from_bytes.h"

#include <string_view>

using namespace splineloft;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto document = readDocument({reinterpret_cast<const char*>(data), size});
    if (!document) {
        fuzz::require(!document.refusal().message().empty(), "a refusal has words");
        return 0;
    }
    const auto text = writeDocument(*document);
    const auto again = readDocument(text);
    fuzz::require(static_cast<bool>(again), "what was written can be read");
    fuzz::require(writeDocument(*again) == text, "what was read is written alike");
    return 0;
}
