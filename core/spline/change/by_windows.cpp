// Families that approach their points, four for each piece: once their parameters are known, the
// recipe that makes a piece from its four points is turned around.
#include "core/spline/catalog.h"
#include "core/spline/change/fit.h"
#include "core/spline/change/proposers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace splineloft::conversion {
namespace {

using Row4 = std::array<double, 4>;
using Matrix = std::array<Row4, 4>;

// Pivots below this are the zero of a recipe in which a point takes no part.
constexpr double leastPivot = 1e-15;

/// The inverse; where the matrix is singular, that of its regular part, with zeros beside it.
Matrix inverse(Matrix matrix) {
    Matrix result{};
    std::array<std::size_t, 4> pivotRow{};
    std::array<bool, 4> rowUsed{}, columnUsed{};
    for (std::size_t i = 0; i < 4; ++i) {
        result[i][i] = 1;
    }
    for (int step = 0; step < 4; ++step) {
        std::size_t row = 0, column = 0;
        double largest = 0;
        for (std::size_t r = 0; r < 4; ++r) {
            for (std::size_t c = 0; c < 4; ++c) {
                if (!rowUsed[r] && !columnUsed[c] && std::abs(matrix[r][c]) > largest) {
                    largest = std::abs(matrix[r][c]);
                    row = r;
                    column = c;
                }
            }
        }
        if (largest < leastPivot) {
            break;
        }
        rowUsed[row] = columnUsed[column] = true;
        pivotRow[column] = row;
        for (std::size_t r = 0; r < 4; ++r) {
            const double factor = r == row ? 0 : matrix[r][column] / matrix[row][column];
            for (std::size_t c = 0; c < 4 && factor != 0; ++c) {
                matrix[r][c] -= factor * matrix[row][c];
                result[r][c] -= factor * result[row][c];
            }
        }
    }
    Matrix ordered{};
    for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t k = 0; k < 4 && columnUsed[c]; ++k) {
            ordered[c][k] = result[pivotRow[c]][k] / matrix[pivotRow[c]][c];
        }
    }
    return ordered;
}

/// From the Bézier points of a piece to the four points of its window. The outer points are sought
/// relative to their neighbours, on which they fall where they take no part.
Matrix unwindingOf(const Spline& spline) {
    Spline window = spline;
    window.closed = false;
    window.ends = Ends::open;
    const auto recipes = blendsOf(window, Points{{0}, {1}, {2}, {3}});
    Matrix matrix{};
    for (std::size_t j = 0; j < 4; ++j) {
        const Blend& recipe = recipes[0][j];
        matrix[j] = {recipe.weight(0), recipe.weight(0) + recipe.weight(1),
                     recipe.weight(2) + recipe.weight(3), recipe.weight(3)};
    }
    Matrix back = inverse(matrix);
    for (std::size_t j = 0; j < 4; ++j) {
        back[0][j] += back[1][j];
        back[3][j] += back[2][j];
    }
    return back;
}

/// Point `index` of the window of a piece.
Point unwound(const Shape& shape, const Matrix& unwinding, std::size_t segment, std::size_t index) {
    const Piece piece = shape.pieces[segment];
    Point place(piece.dimension);
    for (int j = 0; j < 4; ++j) {
        place += unwinding[index][static_cast<std::size_t>(j)] * piece.bezierPoint(j);
    }
    return place;
}

/// Offers the curve with the parameters of `curve`, in all ways of ending. Points in the middle of
/// a window are best known.
bool offerUnwound(const Shape& shape, Trial& trial, Curve curve) {
    if (problemOf(curve)) {
        return trial.offer(curve); // which notes it
    }
    const Matrix unwinding = unwindingOf(curve);
    const auto last = shape.size() - 1;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        curve.points.append(unwound(shape, unwinding, i, 1));
    }
    if (shape.closed) {
        return trial.offer(curve);
    }
    curve.points.append(unwound(shape, unwinding, last, 2));
    for (const Ends ends : {Ends::doubled, Ends::reflected}) {
        curve.ends = ends;
        if (trial.offer(curve)) {
            return true;
        }
    }
    curve.ends = Ends::open;
    curve.points.insert(0, unwound(shape, unwinding, 0, 0));
    curve.points.append(unwound(shape, unwinding, last, 3));
    return trial.offer(curve);
}

/// With b and c the points P, joints J and tangents m = (b/2 + c) D are related by
/// J = P + b/6 (P[-1] - 2 P + P[+1]) and D = P[+1] - P[-1], so that
/// J[+1] - J[-1] = x m + y (m[-1] - 2 m + m[+1]) with x = 1 / (b/2 + c) and y = x b/6.
std::vector<Row> rowsOfJoints(const Shape& shape) {
    std::vector<Row> rows;
    const auto count = shape.joints();
    for (std::size_t i = 0; i < count; ++i) {
        if (shape.isInner(i)) {
            const auto before = (i + count - 1) % count;
            const auto after = (i + 1) % count;
            const Point tangent = shape.leaving(i);
            rows.push_back({tangent, shape.leaving(before) - 2.0 * tangent + shape.leaving(after),
                            shape.joint(after) - shape.joint(before)});
        }
    }
    return rows;
}

/// The rows with x as the only unknown, y being `ratio` times it.
std::vector<Row> withRatio(std::vector<Row> rows, double ratio) {
    for (auto& row : rows) {
        row.first += ratio * row.second;
    }
    return rows;
}

bool allAtRest(const Shape& shape) {
    for (std::size_t i = 0; i < shape.joints(); ++i) {
        if (norm(shape.leaving(i)) > shape.tolerance || norm(shape.arriving(i)) > shape.tolerance) {
            return false;
        }
    }
    return true;
}

/// The derivatives at the joints, as far as beta-splines look at them.
struct Turns {
    std::vector<Row> speeds;     ///< leaving tangent = bias times the arriving one
    std::vector<Point> arriving; ///< second derivatives
    std::vector<Point> leaving;
};

Turns turnsOf(const Shape& shape) {
    Turns turns;
    for (std::size_t i = 0; i < shape.joints(); ++i) {
        if (shape.isInner(i)) {
            const Point tangent = shape.arriving(i);
            turns.speeds.push_back({tangent, Point(tangent.dimension()), shape.leaving(i)});
            turns.arriving.push_back(
                shape.pieces.jet({(i + shape.size() - 1) % shape.size(), 1}).second);
            turns.leaving.push_back(shape.pieces.jet({i, 0}).second);
        }
    }
    return turns;
}

} // namespace

void proposeBcSpline(const Shape& shape, Trial& trial) {
    const auto rows = rowsOfJoints(shape);
    const auto offered = [&](double b, double c) {
        Curve curve = trial.blank();
        curve.parameters["b"] = tidied(b, curve, "b");
        curve.parameters["c"] = tidied(c, curve, "c");
        return offerUnwound(shape, trial, curve);
    };
    if (allAtRest(shape) && offered(0, 0)) {
        return;
    }
    const auto both = fitTwo(rows);
    if (both && both->x != 0) {
        const double b = 6 * both->y / both->x;
        if (offered(b, 1 / both->x - b / 2)) {
            return;
        }
    }
    // Little data, as of two pieces on one line, leaves a choice: an edge of the square or its
    // middle.
    const Curve blank = trial.blank();
    for (const double b : {0.0, 1.0, parameterOf(blank, "b")}) {
        const auto x = fitOne(withRatio(rows, b / 6), shape.tolerance);
        if (x && *x != 0 && offered(b, 1 / *x - b / 2)) {
            return;
        }
    }
    offered(parameterOf(blank, "b"), parameterOf(blank, "c"));
}

void proposeDuff(const Shape& shape, Trial& trial) {
    Curve curve = trial.blank();
    std::vector<double> tensions = {allAtRest(shape) ? 0.0 : parameterOf(curve, "tension")};
    auto rows = rowsOfJoints(shape); // b is the tension and c is 0: x = 2 / a, y = 1/3
    for (auto& row : rows) {
        row.right -= (1.0 / 3) * row.second;
    }
    const auto x = fitOne(rows, shape.tolerance);
    if (x && *x != 0) {
        tensions.insert(tensions.begin(), tidied(2 / *x, curve, "tension"));
    }
    for (const double tension : tensions) {
        curve.parameters["tension"] = tension;
        if (offerUnwound(shape, trial, curve)) {
            return;
        }
    }
}

void proposeBeta(const Shape& shape, Trial& trial) {
    Curve curve = trial.blank();
    const Turns turns = turnsOf(shape);
    const auto speed = fitOne(turns.speeds, shape.tolerance);
    if (speed) {
        const double bias = tidied(*speed, curve, "bias");
        std::vector<Row> rows = turns.speeds;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            rows[i].right = turns.leaving[i] - bias * bias * turns.arriving[i];
        }
        const double tension = fitOne(rows, shape.tolerance).value_or(0);
        curve.parameters["bias"] = bias;
        curve.parameters["tension"] = tidied(tension, curve, "tension");
        if (offerUnwound(shape, trial, curve)) {
            return;
        }
    }
    offerUnwound(shape, trial, trial.blank());
}

} // namespace splineloft::conversion
