#include "app/fonts.h"

#include "app/window_error.h"

#include <fontconfig/fontconfig.h>

#include <initializer_list>
#include <memory>
#include <string>

namespace splineloft::app {

namespace {

struct Freed {
    void operator()(FcConfig* config) const { FcConfigDestroy(config); }
    void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
    void operator()(FcCharSet* letters) const { FcCharSetDestroy(letters); }
};

template <typename T> using Owned = std::unique_ptr<T, Freed>;

Owned<FcCharSet> lettersNeeded() {
    Owned<FcCharSet> letters(FcCharSetCreate());
    for (const FcChar32 letter : {U'A', U'β', U'κ', U'μ', U'Δ'}) {
        FcCharSetAddChar(letters.get(), letter);
    }
    return letters;
}

// Of all that fontconfig weighs, the letters weigh most, then the name of the family.
std::string findFont(FcConfig* config, int weight) {
    const auto letters = lettersNeeded();
    const Owned<FcPattern> wanted(FcPatternCreate());
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("DejaVu Sans"));
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
    FcPatternAddCharSet(wanted.get(), FC_CHARSET, letters.get());
    FcPatternAddInteger(wanted.get(), FC_WEIGHT, weight);
    FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
    FcPatternAddString(wanted.get(), FC_FONTFORMAT, reinterpret_cast<const FcChar8*>("TrueType"));
    FcConfigSubstitute(config, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    auto result = FcResultNoMatch;
    const Owned<FcPattern> found(FcFontMatch(config, wanted.get(), &result));
    FcChar8* file = nullptr;
    if (!found || FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch) {
        throw WindowError("no font with Greek letters is installed (fonts-dejavu-core has them)");
    }
    return reinterpret_cast<const char*>(file);
}

} // namespace

ui::Fonts findFonts() {
    const Owned<FcConfig> config(FcInitLoadConfigAndFonts());
    if (!config) {
        throw WindowError("fontconfig cannot read its configuration (is fontconfig installed?)");
    }
    return {findFont(config.get(), FC_WEIGHT_REGULAR), findFont(config.get(), FC_WEIGHT_BOLD)};
}

} // namespace splineloft::app
