// Reading JSON values that have to be of a certain kind, and saying where one is not.
#pragma once

#include "core/formats/json_tape.h"
#include "core/spline/problem.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace splineloft {

using Keys = std::vector<std::string_view>;

/// Words with commas between them.
std::string listed(const Keys& words);

/// Remembers the first thing that is wrong. After that whoever reads only has to come to an end:
/// what is returned then is not used.
class ValueReader {
  public:
    using Members = std::map<std::string_view, JsonValue>;

    const std::optional<Refusal>& refusal() const { return refusal_; }

    void refuse(const JsonPlace& place, std::string what, std::string remedy);
    void refuseProblem(const std::optional<Problem>& problem, const JsonPlace& within = {});

    /// Whether the value is of this kind; refuses it otherwise.
    bool expect(const JsonValue& value, JsonKind kind, const JsonPlace& place);

    Members membersOf(const JsonValue& object, const JsonPlace& place);

    /// Calls `visit(entry, place)` for the entries of an array, up to the first refusal.
    template <class Visit>
    void eachOf(const JsonValue& array, const JsonPlace& place, Visit visit) {
        if (!expect(array, JsonKind::array, place)) {
            return;
        }
        std::size_t index = 0;
        for (auto entry = array.inside(); !array.ends(entry) && !refusal_; entry = entry.next()) {
            visit(entry, JsonPlace(place, index++));
        }
    }

    /// The member of that key, or null.
    static const JsonValue* optional(const Members& members, std::string_view key);
    const JsonValue* required(const Members& members, std::string_view key, const JsonPlace& place,
                              std::string remedy);

    /// Refuses keys that are not among these; `owner` is what has them.
    void allowOnly(const Keys& keys, const Members& members, const JsonPlace& place,
                   std::string_view owner);

    double number(const JsonValue& value, const JsonPlace& place);
    bool boolean(const JsonValue& value, const JsonPlace& place);
    std::string text(const JsonValue& value, const JsonPlace& place);

  private:
    std::optional<Refusal> refusal_;
};

} // namespace splineloft
