// The document that most tests of the command line call it with.
#pragma once

#include "tests/interop/run.h"

namespace splineloft {

// Off the origin and without symmetry, so that wrong signs show.
inline const std::string path = R"({"name": "path", "family": "cardinal",
    "points": [[-3.5, 0.25], [-1, 2], [2.25, -1.5], [4, 1]]})";
inline const std::string number =
    R"({"name": "0", "family": "linear", "points": [[1, 2], [4, 6], [4, 7]]})";
inline const std::string uneven = R"({"name": "uneven", "family": "catmull-rom",
    "parameters": {"alpha": 1}, "points": [[1, 1], [3, 4], [8, 2], [9, 5]]})";
inline const std::string hermite = R"({"name": "h", "family": "hermite",
    "points": [[1, 2], [3, 5]], "tangents": [[0, 0], [2, -1]]})";
inline const std::string sample = curves(path + "," + number + "," + uneven + "," + hermite);

} // namespace splineloft
