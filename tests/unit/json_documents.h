// Small documents as JSON text, for tests.
#pragma once

#include <cstddef>
#include <string>

namespace splineloft {

inline std::string withCurves(const std::string& curves) {
    return R"({"format": "splineloft", "version": 1, "curves": [)" + curves + "]}";
}

/// A curve of which only some keys matter: the others are good.
inline std::string curveWith(const std::string& keys) {
    return withCurves(R"({"family": "cardinal", "points": [[0, 1], [2, 3]])" +
                      (keys.empty() ? "" : ", " + keys) + "}");
}

/// One linear curve.
inline std::string linear(const std::string& points, const std::string& more = "") {
    return withCurves(R"({"family": "linear", "points": )" + points + more + "}");
}

inline std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) {
        all += text;
    }
    return all;
}

} // namespace splineloft
