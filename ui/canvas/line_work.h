// How a curve and the lines beside it get onto the canvas: a few pieces as strokes laid out here,
// very many as runs of pieces that the renderer lays out by itself. Both look the same.
#pragma once

#include "ui/canvas/scene.h"
#include "ui/canvas/viewport.h"
#include "ui/plane_study.h"

namespace splineloft::ui {

/// More pieces than these in view are left to the renderer.
inline constexpr std::size_t mostPiecesLaidOut = 600;

/// Adds the curve's line.
void drawCurve(Scene& scene, const PlaneStudy& plane, bool closed, Ink ink,
               const Viewport& viewport);

/// Adds the legs from control point to control point.
void drawPolygon(Scene& scene, const PlaneStudy& plane, bool closed, Ink ink,
                 const Viewport& viewport);

/// Adds the lines from the anchors of a Bézier spline to their handles.
void drawHandles(Scene& scene, const PlaneStudy& plane, const Curve& curve, Ink ink,
                 const Viewport& viewport);

std::size_t membersOf(std::span<const Range> ranges);

/// The neighbouring blocks of a tree that can be seen, as ranges of its members.
std::vector<Range> rangesInView(const BoxTree& boxes, const Viewport& viewport);

/// Which members of a sequence to show: all of a short one; of a long one those in view, and of
/// very many only every `step`th.
struct Sampling {
    std::vector<Range> ranges;
    std::size_t step = 1;
};
Sampling samplingOf(const BoxTree& boxes, std::size_t most, const Viewport& viewport);

} // namespace splineloft::ui
