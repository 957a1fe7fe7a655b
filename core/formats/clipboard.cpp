#include "core/formats/clipboard.h"

#include "core/document/edits.h"
#include "core/document/handles.h"
#include "core/document/lists.h"
#include "core/document/tidy.h"
#include "core/formats/document_json.h"
#include "core/formats/json_tape.h"
#include "core/formats/number_lines.h"
#include "core/formats/svg_path.h"
#include "core/formats/value_reader.h"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

namespace splineloft {
namespace {

using Indices = std::set<std::size_t>;

/// What is copied for a control point: of a Bézier spline the anchor that it belongs to, and for a
/// last handle, whose anchor is not there yet, the last one.
std::size_t copiedFor(const Curve& curve, std::size_t index) {
    return hasHandles(curve) ? anchorOf(curve, index).value_or(index - index % 3) : index;
}

/// The curve with these control points only, at least one; of a Bézier spline with these anchors.
CurveEntry only(const CurveEntry& entry, const Indices& kept) {
    Document document;
    document.curves.push_back(entry);
    // Automatic handles would follow anchors that are not copied.
    std::erase_if(document.curves[0].handleModes,
                  [](const auto& anchor) { return anchor.second == HandleMode::automatic; });
    std::vector<PointId> others;
    const std::size_t step = hasHandles(*entry) ? 3 : 1;
    for (std::size_t i = 0; i < entry->points.size(); i += step) {
        if (!kept.contains(i)) {
            others.push_back({0, i});
        }
    }
    if (others.empty()) {
        return entry;
    }
    auto unknotted = std::make_shared<Curve>(*entry);
    if (!unknotted->knots.empty()) {
        dropKnots(*unknotted);
    }
    document.curves[0] = std::move(unknotted);
    return setClosed(deletePoints(document, others), 0, false).curves[0];
}

std::string textOf(std::vector<CurveEntry> curves) {
    Document document;
    document.curves = std::move(curves);
    return writeDocument(document);
}

/// The refusal of a document into which a text was wrapped, without that.
Refusal unwrapped(Refusal refusal, std::string_view prefix) {
    if (refusal.place.starts_with(prefix)) {
        refusal.place.erase(0, prefix.size());
    }
    return refusal;
}

Result<std::vector<CurveEntry>> curvesOf(const Result<Document>& document) {
    if (!document) {
        return document.refusal();
    }
    return document->curves;
}

Result<std::vector<CurveEntry>> wrapped(std::string_view text, std::string_view before,
                                        std::string_view after, std::string_view prefix) {
    const auto document =
        readDocument(R"({"format": "splineloft", "version": 1, "curves": [)" + std::string(before) +
                     std::string(text) + std::string(after) + "]}");
    if (!document) {
        return unwrapped(document.refusal(), prefix);
    }
    return document->curves;
}

/// A document, a curve or an array of points.
Result<std::vector<CurveEntry>> fromJson(std::string_view text) {
    const auto tape = readJson(text, {});
    if (!tape) {
        return tape.refusal();
    }
    if (tape->root().kind() == JsonKind::array) {
        return wrapped(text, R"({"family": "cardinal", "name": "points", "points": )", "}",
                       "/curves/0/points");
    }
    ValueReader reader;
    const auto members = reader.membersOf(tape->root(), JsonPlace());
    const bool isDocument = members.contains("format") || members.contains("curves");
    return isDocument ? curvesOf(readDocument(text)) : wrapped(text, "", "", "/curves/0");
}

/// Mirrors plane curves about the middle between their lowest and highest coordinate: y down
/// becomes y up.
std::vector<CurveEntry> upright(std::vector<Curve> curves) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const auto& curve : curves) {
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            low = std::min(low, curve.points[i][1]);
            high = std::max(high, curve.points[i][1]);
        }
    }
    std::vector<CurveEntry> entries;
    for (auto& curve : curves) {
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const auto place = curve.points[i];
            curve.points.set(i, {place[0], cleanSum(low + high, -place[1])});
        }
        entries.push_back(std::make_shared<Curve>(std::move(curve)));
    }
    return entries;
}

/// Collects the paths that an SVG document draws.
class PathCollector : public pugi::xml_tree_walker {
  public:
    bool for_each(pugi::xml_node& node) override {
        if (std::string_view(node.name()) != "path" || isTemplate(node.parent())) {
            return true;
        }
        auto found = curvesFromPathData(node.attribute("d").value());
        if (!found) {
            refusal_ = found.refusal();
            refusal_->what = "path " + std::to_string(paths_ + 1) + ": " + refusal_->what;
            return false;
        }
        ++paths_;
        const std::string name = node.attribute("id").value();
        for (auto& curve : *found) {
            curve.name = name.empty() ? curve.name : name;
            curves_.push_back(std::move(curve));
        }
        return true;
    }

    const std::optional<Refusal>& refusal() const { return refusal_; }
    std::vector<Curve> curves() && { return std::move(curves_); }

  private:
    /// Whether a node's paths are not drawn where they stand.
    static bool isTemplate(pugi::xml_node node) {
        constexpr std::array names = {"defs", "clipPath", "mask", "marker", "pattern", "symbol"};
        for (; node; node = node.parent()) {
            if (std::ranges::find(names, std::string_view(node.name())) != names.end()) {
                return true;
            }
        }
        return false;
    }

    std::vector<Curve> curves_;
    std::size_t paths_ = 0;
    std::optional<Refusal> refusal_;
};

Result<std::vector<CurveEntry>> fromSvg(std::string_view text) {
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text.data(), text.size());
    if (!parsed) {
        return Refusal{"", "byte " + std::to_string(parsed.offset), parsed.description(),
                       "an SVG file"};
    }
    PathCollector paths;
    document.traverse(paths);
    if (paths.refusal()) {
        return *paths.refusal();
    }
    return upright(std::move(paths).curves());
}

Result<std::vector<CurveEntry>> fromPathData(std::string_view text) {
    auto curves = curvesFromPathData(text);
    if (!curves) {
        return curves.refusal();
    }
    return upright(std::move(*curves));
}

Result<std::vector<CurveEntry>> fromLines(std::string_view text) {
    auto curve = curveFromLines(text);
    if (!curve) {
        return curve.refusal();
    }
    return std::vector<CurveEntry>{std::make_shared<Curve>(std::move(*curve))};
}

/// Whether a text begins as path data do: a move, and then a number.
bool isPathData(std::string_view text) {
    if (text[0] != 'M' && text[0] != 'm') {
        return false;
    }
    const auto second = text.find_first_not_of(" \t\r\n\f", 1);
    return second != text.npos && std::string_view("0123456789+-.").find(text[second]) != text.npos;
}

Result<std::vector<CurveEntry>> curvesIn(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\n\v\f");
    if (first == text.npos) {
        return Refusal{"", "", "is empty", "curves or points as text"};
    }
    if (const auto at = text.find('\0'); at != text.npos) {
        return Refusal{"", "byte " + std::to_string(at), "is a NUL character", "text without it"};
    }
    if (text.size() > largestFile) {
        return Refusal{"", "", "has " + std::to_string(text.size()) + " bytes", "at most 64 MB"};
    }
    const char start = text[first];
    if (start == '{' || start == '[') {
        return fromJson(text);
    }
    if (start == '<') {
        return fromSvg(text);
    }
    return isPathData(text.substr(first)) ? fromPathData(text) : fromLines(text);
}

} // namespace

std::string copiedCurves(const Document& document, std::span<const std::size_t> curves) {
    std::vector<CurveEntry> copied;
    for (const auto index : Indices(curves.begin(), curves.end())) {
        copied.push_back(document.curves.at(index));
    }
    return textOf(std::move(copied));
}

std::string copiedPoints(const Document& document, std::span<const PointId> ids) {
    std::map<std::size_t, Indices> kept; // by curve
    for (const auto& id : ids) {
        kept[id.curve].insert(copiedFor(*document.curves.at(id.curve), id.index));
    }
    std::vector<CurveEntry> copied;
    for (const auto& [curve, indices] : kept) {
        copied.push_back(only(document.curves[curve], indices));
    }
    return textOf(std::move(copied));
}

Result<Pasted> pasted(std::string_view text) {
    auto curves = curvesIn(text);
    if (!curves) {
        return curves.refusal();
    }
    if (curves->empty()) {
        return Refusal{"", "", "has no curve", "one curve or more"};
    }
    Document document;
    document.curves = *curves;
    if (const auto problem = problemOf(document)) {
        return Refusal{"", problem->place, problem->what, problem->remedy};
    }
    return Pasted{std::move(*curves)};
}

} // namespace splineloft
