#include "ui/canvas/line_work.h"

#include "core/document/handles.h"
#include "ui/canvas/outline.h"

#include <bit>
#include <cmath>

namespace splineloft::ui {
namespace {

constexpr double smallest = 0.7;     // pixels: several pieces no larger than this are one segment
constexpr std::size_t finest = 64;   // segments for one piece
constexpr std::size_t coarsest = 64; // pieces for one segment
constexpr std::size_t mostSegments = 200'000; // of one stroke

/// How finely the pieces of a block must be drawn, on the screen.
PieceRun runOf(const Range& block, const Detail& detail, int degree, double pixelsPerUnit) {
    PieceRun run{block.first, block.last, 1, 1};
    const double largest = detail.largest * pixelsPerUnit;
    if (largest * 2 <= smallest) {
        const auto fit = largest > 0 ? smallest / largest : static_cast<double>(coarsest);
        run.step =
            std::bit_floor(static_cast<std::size_t>(std::min(fit, static_cast<double>(coarsest))));
        return run;
    }
    // The chord of a part of length h in u is within h^2 max|P''| / 8 of it, and the second
    // derivative within d (d - 1) times the largest second difference of the Bézier points.
    const double bend = degree * (degree - 1) * detail.bend * pixelsPerUnit / 8;
    const double wanted =
        std::clamp(std::sqrt(bend / lineFlatness), 1.0, static_cast<double>(finest));
    run.segments = std::bit_ceil(static_cast<std::size_t>(std::ceil(wanted)));
    return run;
}

std::size_t segmentsOf(const std::vector<PieceRun>& runs) {
    std::size_t count = 0;
    for (const auto& run : runs) {
        count += (run.last - run.first) * run.segments / run.step;
    }
    return count;
}

/// Draws all runs more coarsely until a card has done with them within a frame: where so many
/// pieces are in view, they fill it.
void coarsen(std::vector<PieceRun>& runs) {
    while (segmentsOf(runs) > mostSegments) {
        bool coarser = false;
        for (auto& run : runs) {
            if (run.segments > 1) {
                run.segments /= 2;
            } else if (run.step < coarsest) {
                run.step *= 2;
            } else {
                continue;
            }
            coarser = true;
        }
        if (!coarser) {
            return;
        }
    }
}

/// Runs for the blocks of some ranges, as few as possible.
template <class RunOf>
std::vector<PieceRun> runsOf(std::span<const Range> ranges, const BoxTree& boxes, RunOf runFor) {
    std::vector<PieceRun> runs;
    for (const auto& range : ranges) {
        for (auto first = range.first; first < range.last; first += BoxTree::blockSize) {
            const auto block = first / BoxTree::blockSize;
            const PieceRun run = runFor(boxes.block(block), block);
            if (!runs.empty() && runs.back().last == run.first &&
                runs.back().segments == run.segments && runs.back().step == run.step) {
                runs.back().last = run.last;
            } else {
                runs.push_back(run);
            }
        }
    }
    coarsen(runs);
    return runs;
}

ScenePieces piecesFor(const Scene& scene, const PieceTable& table, Ink ink,
                      const Viewport& viewport) {
    PieceStroke stroke;
    stroke.table = table;
    stroke.centre = viewport.camera.centre;
    stroke.origin = viewport.toScreen(viewport.camera.centre);
    stroke.pixelsPerUnit = viewport.camera.pixelsPerUnit;
    return {std::move(stroke), ink, scene.strokes.size()};
}

/// The renderer takes cubics and below, without weights.
bool isSimple(const Pieces& pieces) {
    return pieces.form() == Form::polynomial && pieces.degree() >= 1 && pieces.degree() <= 3;
}

PieceTable tableOf(const PlaneStudy& plane) {
    const auto stride = static_cast<std::size_t>(plane.pieces().degree()) + 1;
    const auto numbers = plane.pieces().bezier();
    static_assert(sizeof(PlanePoint) == 2 * sizeof(double));
    return {{reinterpret_cast<const PlanePoint*>(numbers.data()), numbers.size() / 2},
            plane.pieces().degree(),
            stride,
            BoxTree::blockSize * stride,
            &plane.revisions()};
}

std::vector<PieceRun> curveRuns(const PlaneStudy& plane, std::span<const Range> ranges,
                                const Viewport& viewport) {
    return runsOf(ranges, plane.boxes(), [&](const Range& block, std::size_t index) {
        return runOf(block, plane.detail(index), plane.pieces().degree(),
                     viewport.camera.pixelsPerUnit);
    });
}

void addStroke(Scene& scene, SceneStroke stroke) {
    if (!stroke.points.empty()) {
        scene.strokes.push_back(std::move(stroke));
    }
}

/// Legs from `range.first` to the point after the range, where there is one.
void addLegs(Scene& scene, const PlacedPoints& points, const Range& range, bool closed, Ink ink,
             const Viewport& viewport) {
    const auto count = points.places().size();
    const bool whole = range.size() == count;
    SceneStroke stroke{{}, ink, closed && whole};
    const auto last = range.last < count ? range.last + 1 : count;
    for (auto i = range.first; i < last; ++i) {
        stroke.points.push_back(viewport.toScreen(points.places()[i]));
    }
    if (closed && !whole && range.last == count) {
        stroke.points.push_back(viewport.toScreen(points.places()[0]));
    }
    stroke.laid = points.way(range.first) * viewport.camera.pixelsPerUnit;
    if (stroke.points.size() > 1) {
        addStroke(scene, std::move(stroke));
    }
}

} // namespace

std::size_t membersOf(std::span<const Range> ranges) {
    std::size_t count = 0;
    for (const auto& range : ranges) {
        count += range.size();
    }
    return count;
}

std::vector<Range> rangesInView(const BoxTree& boxes, const Viewport& viewport) {
    std::vector<Range> ranges;
    boxes.touching(viewport.visible(lineOverhang), [&](std::size_t index) {
        const Range block = boxes.block(index);
        if (!ranges.empty() && ranges.back().last == block.first) {
            ranges.back().last = block.last;
        } else {
            ranges.push_back(block);
        }
    });
    return ranges;
}

Sampling samplingOf(const BoxTree& boxes, std::size_t most, const Viewport& viewport) {
    if (boxes.count() <= most) {
        return {{{0, boxes.count()}}};
    }
    auto ranges = rangesInView(boxes, viewport);
    const auto inView = membersOf(ranges);
    return {std::move(ranges), std::bit_ceil(std::max<std::size_t>((inView + most - 1) / most, 1))};
}

void drawCurve(Scene& scene, const PlaneStudy& plane, bool closed, Ink ink,
               const Viewport& viewport) {
    const auto& pieces = plane.pieces();
    if (pieces.size() <= mostPiecesLaidOut) {
        return addStroke(scene, {outline(pieces, viewport), ink});
    }
    const auto ranges = rangesInView(plane.boxes(), viewport);
    if (membersOf(ranges) > mostPiecesLaidOut && isSimple(pieces)) {
        auto drawn = piecesFor(scene, tableOf(plane), ink, viewport);
        drawn.stroke.runs = curveRuns(plane, ranges, viewport);
        drawn.stroke.closed = closed;
        scene.pieces.push_back(std::move(drawn));
        return;
    }
    for (const auto& range : ranges) {
        addStroke(scene, {outline(pieces.part(range), viewport), ink});
    }
}

void drawPolygon(Scene& scene, const PlaneStudy& plane, bool closed, Ink ink,
                 const Viewport& viewport) {
    const auto& points = plane.points();
    const auto count = points.places().size();
    if (count <= mostPiecesLaidOut) {
        return addLegs(scene, points, {0, count}, closed, ink, viewport);
    }
    const auto ranges = rangesInView(points.boxes(), viewport);
    if (membersOf(ranges) <= mostPiecesLaidOut) {
        for (const auto& range : ranges) {
            addLegs(scene, points, range, closed, ink, viewport);
        }
        return;
    }
    const PieceTable table{points.places(), 1, 1, BoxTree::blockSize, &points.revisions()};
    auto drawn = piecesFor(scene, table, ink, viewport);
    drawn.stroke.closed = closed;
    drawn.stroke.runs = runsOf(ranges, points.boxes(), [&](Range block, std::size_t index) {
        const Detail detail{points.legs(index).longest, 0};
        if (!closed && block.last == count) {
            --block.last; // the last point of all begins no leg
        }
        return runOf(block, detail, 1, viewport.camera.pixelsPerUnit);
    });
    scene.pieces.push_back(std::move(drawn));
}

void drawHandles(Scene& scene, const PlaneStudy& plane, const Curve& curve, Ink ink,
                 const Viewport& viewport) {
    const auto places = plane.points().places();
    const auto ranges = places.size() <= mostPiecesLaidOut
                            ? std::vector<Range>{{0, places.size()}}
                            : rangesInView(plane.points().boxes(), viewport);
    if (membersOf(ranges) > mostPiecesLaidOut && isSimple(plane.pieces())) {
        for (const auto line : {PieceLine::firstLeg, PieceLine::lastLeg}) {
            auto drawn = piecesFor(scene, tableOf(plane), ink, viewport);
            drawn.stroke.line = line;
            for (auto run : curveRuns(plane, rangesInView(plane.boxes(), viewport), viewport)) {
                if (run.step == 1) { // else they cannot be told from the curve
                    run.segments = 1;
                    drawn.stroke.runs.push_back(run);
                }
            }
            scene.pieces.push_back(std::move(drawn));
        }
        return;
    }
    for (const auto& range : ranges) {
        for (auto i = range.first; i < range.last; ++i) {
            if (const auto anchor = anchorOf(curve, i)) {
                addStroke(
                    scene,
                    {{viewport.toScreen(places[*anchor]), viewport.toScreen(places[i])}, ink});
            }
        }
    }
}

} // namespace splineloft::ui
