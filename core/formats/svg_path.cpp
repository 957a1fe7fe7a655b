#include "core/formats/svg_path.h"

#include "core/formats/svg_arc.h"
#include "core/formats/svg_scanner.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

// A subpath that comes back to within this part of its size is meant to come back to its start:
// what is left is the rounding of relative coordinates.
constexpr double returned = 1e-6;

bool isRelative(char command) {
    return command >= 'a';
}

char absolute(char command) {
    return isRelative(command) ? static_cast<char>(command - 'a' + 'A') : command;
}

/// A subpath as the control points of a Bézier spline.
struct Subpath {
    std::vector<PlanePlace> points;
    bool isStraight = true;
    bool isClosed = false;
};

PlanePlace between(PlanePlace a, PlanePlace b, double u) {
    return {std::lerp(a.x, b.x, u), std::lerp(a.y, b.y, u)};
}

double distance(PlanePlace a, PlanePlace b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// Draws what the commands say.
class Pen {
  public:
    PlanePlace place() const { return place_; }

    void moveTo(PlanePlace to) {
        place_ = start_ = to;
        isDown_ = false;
    }
    void lineTo(PlanePlace to) {
        draw({between(place_, to, 1.0 / 3), between(place_, to, 2.0 / 3), to}, true);
    }
    void cubicTo(const CubicTo& cubic) { draw(cubic, false); }
    void quadraticTo(PlanePlace handle, PlanePlace to) {
        draw({between(place_, handle, 2.0 / 3), between(to, handle, 2.0 / 3), to}, false);
    }
    void close() {
        if (isDown_) {
            subpaths_.back().isClosed = true;
        }
        moveTo(start_);
    }

    const std::vector<Subpath>& subpaths() const { return subpaths_; }

  private:
    void draw(const CubicTo& cubic, bool isStraight) {
        if (!isDown_) {
            subpaths_.push_back({{place_}});
            isDown_ = true;
        }
        auto& subpath = subpaths_.back();
        subpath.points.insert(subpath.points.end(), cubic.begin(), cubic.end());
        subpath.isStraight = subpath.isStraight && isStraight;
        place_ = cubic[2];
    }

    std::vector<Subpath> subpaths_;
    PlanePlace place_, start_;
    bool isDown_ = false; ///< on the latest subpath
};

/// Carries the commands of path data out, up to the first that cannot be read.
class PathReader {
  public:
    explicit PathReader(std::string_view data) : scanner_(data) {}

    Result<std::vector<Subpath>> subpaths() {
        while (!scanner_.atEnd() && !refusal_) {
            readCommand();
        }
        if (refusal_) {
            return *refusal_;
        }
        return pen_.subpaths();
    }

  private:
    void refuse(std::size_t at, std::string what, std::string remedy) {
        if (!refusal_) {
            refusal_ =
                Refusal{"", "byte " + std::to_string(at), std::move(what), std::move(remedy)};
        }
    }

    void readCommand() {
        constexpr std::string_view commands = "MLHVCSQTAZ";
        const auto at = scanner_.at();
        const char command = scanner_.letter();
        if (commands.find(absolute(command)) == commands.npos) {
            refuse(at, inQuotes(std::string_view(&command, 1)) + " is no command of path data",
                   "one of M L H V C S Q T A Z, or in small letters");
            return;
        }
        if (!hasMoved_ && absolute(command) != 'M') {
            refuse(at, "path data begin with " + inQuotes(std::string_view(&command, 1)), "M or m");
            return;
        }
        hasMoved_ = true;
        if (absolute(command) == 'Z') {
            pen_.close();
            before_ = 'Z';
            return;
        }
        char repeated = command;
        do {
            carryOut(repeated);
            if (absolute(command) == 'M') { // what follows a move are lines
                repeated = command == 'M' ? 'L' : 'l';
            }
        } while (scanner_.atNumber() && !refusal_);
    }

    void carryOut(char command) {
        const PlanePlace from = pen_.place();
        const PlanePlace origin = isRelative(command) ? from : PlanePlace{};
        const PlanePlace mirrored = {2 * from.x - handle_.x, 2 * from.y - handle_.y};
        const char kind = absolute(command);
        switch (kind) {
        case 'M': step([&](PlanePlace to) { pen_.moveTo(to); }, origin); break;
        case 'L': step([&](PlanePlace to) { pen_.lineTo(to); }, origin); break;
        case 'H': line({number() + origin.x, from.y}); break;
        case 'V': line({from.x, number() + origin.y}); break;
        case 'C': {
            const PlanePlace first = place(origin);
            cubic(first, origin);
            break;
        }
        case 'S': cubic(before_ == 'C' || before_ == 'S' ? mirrored : from, origin); break;
        case 'Q': {
            const PlanePlace handle = place(origin);
            quadratic(handle, origin);
            break;
        }
        case 'T': quadratic(before_ == 'Q' || before_ == 'T' ? mirrored : from, origin); break;
        default: arc(origin);
        }
        before_ = kind;
    }

    template <class Go> void step(Go go, PlanePlace origin) {
        const PlanePlace to = place(origin);
        if (!refusal_) {
            go(to);
        }
    }
    void line(PlanePlace to) {
        if (!refusal_) {
            pen_.lineTo(to);
        }
    }
    void cubic(PlanePlace first, PlanePlace origin) {
        const PlanePlace second = place(origin);
        const PlanePlace to = place(origin);
        if (!refusal_) {
            pen_.cubicTo({first, second, to});
            handle_ = second;
        }
    }
    void quadratic(PlanePlace handle, PlanePlace origin) {
        const PlanePlace to = place(origin);
        if (!refusal_) {
            pen_.quadraticTo(handle, to);
            handle_ = handle;
        }
    }
    void arc(PlanePlace origin) {
        SvgArc arc;
        arc.start = pen_.place();
        arc.radiusX = number();
        arc.radiusY = number();
        arc.rotation = number();
        arc.isLarge = flag();
        arc.sweeps = flag();
        arc.end = place(origin);
        if (refusal_) {
            return;
        }
        if (arc.radiusX == 0 || arc.radiusY == 0) {
            pen_.lineTo(arc.end);
            return;
        }
        for (const auto& cubic : cubicsOf(arc)) {
            pen_.cubicTo(cubic);
        }
    }

    double number() {
        const auto at = scanner_.at();
        const auto value = scanner_.number();
        if (!value) {
            refuse(at, scanner_.atEnd() ? "the data end" : "there is no number that can be read",
                   "a number");
        }
        return value.value_or(0);
    }
    bool flag() {
        const auto at = scanner_.at();
        const auto value = scanner_.flag();
        if (!value) {
            refuse(at, "there is no flag of an arc", "0 or 1");
        }
        return value.value_or(false);
    }
    PlanePlace place(PlanePlace origin) {
        const double x = number();
        const double y = number();
        return {origin.x + x, origin.y + y};
    }

    SvgScanner scanner_;
    Pen pen_;
    char before_ = 'Z'; ///< the command before, as a capital letter
    PlanePlace handle_; ///< the last handle of a C, S, Q or T
    bool hasMoved_ = false;
    std::optional<Refusal> refusal_;
};

double sizeOf(const std::vector<PlanePlace>& points) {
    const auto [left, right] = std::ranges::minmax_element(points, {}, &PlanePlace::x);
    const auto [low, high] = std::ranges::minmax_element(points, {}, &PlanePlace::y);
    return std::max(right->x - left->x, high->y - low->y);
}

/// What closes a subpath: it comes back to its first point, which stands there once.
void closeUp(std::vector<PlanePlace>& points) {
    const PlanePlace first = points.front();
    const PlanePlace last = points.back();
    if (distance(first, last) <= returned * sizeOf(points)) {
        points.pop_back();
        return;
    }
    points.push_back(between(last, first, 1.0 / 3));
    points.push_back(between(last, first, 2.0 / 3));
}

Curve curveOf(Subpath subpath) {
    Curve curve;
    curve.name = "path";
    curve.ends = Ends::none;
    constexpr std::size_t twoPieces = 7; // a closed curve needs to go somewhere and come back
    curve.closed =
        subpath.isClosed && subpath.points.size() >= (subpath.isStraight ? twoPieces : 4);
    if (curve.closed) {
        closeUp(subpath.points);
    }
    curve.family = subpath.isStraight ? "linear" : "bezier-spline";
    for (std::size_t i = 0; i < subpath.points.size(); i += subpath.isStraight ? 3 : 1) {
        curve.points.append({subpath.points[i].x, subpath.points[i].y});
    }
    return curve;
}

} // namespace

Result<std::vector<Curve>> curvesFromPathData(std::string_view data) {
    const auto subpaths = PathReader(data).subpaths();
    if (!subpaths) {
        return subpaths.refusal();
    }
    std::vector<Curve> curves;
    for (const auto& subpath : *subpaths) {
        curves.push_back(curveOf(subpath));
    }
    return curves;
}

} // namespace splineloft
