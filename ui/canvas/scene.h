// What is to be seen, in pixels but without colours: strokes, marks and labels, each with the role
// that it plays. The theme alone knows how a role looks.
#pragma once

#include "ui/drawing.h"

#include <string>
#include <vector>

namespace splineloft::ui {

/// The part that a stroke, mark or label plays.
enum class Role {
    gridFine,
    gridCoarse,
    gridAxis,
    gridNumber,
    curve,      ///< the active curve; the index is the colour of its look
    otherCurve, ///< the others, with theirs
    curveHalo,  ///< the active curve under the pointer
    polygon,
    handleLine,
    control,      ///< a control point, in its own colour
    handle,       ///< a handle or the tip of a tangent, in its own colour
    otherControl, ///< of a curve that is not active; the index is the colour of its look
    selected,
    hovered,
    ghost,
    ladder, ///< a level of de Casteljau's construction; the index is the level
    tip,    ///< its last point: the point of the curve
    comb,
    combEdge,
    bead,
    joint,
    frame,       ///< an arrow at a bead: 0 the tangent, then the normals
    cursorFrame, ///< the same at the cursor
    jointNote,
    box,    ///< rubber band
    snap,   ///< what a drag has snapped to
    course, ///< the line that a drag keeps to
    gizmo,  ///< the frame around several selected points
    grip,
    gripHeld, ///< under the pointer or in the hand
    stem,     ///< the track of a number at its point
    stemFilled,
    plotAxis,
    plotZero,  ///< the line at zero, where values may lie on both sides
    plotJoint, ///< where one piece gives way to the next
    plotBand,
    plotCursor,
    plotText,
    motion,      ///< the graph of speed, acceleration or curvature
    basis,       ///< a basis function, in its control point's colour
    tangentBasis ///< that of a tangent: in its point's colour, dashed
};

/// A role, and of which control point or level.
struct Ink {
    Role role = Role::curve;
    int index = 0;
};

struct SceneStroke {
    std::vector<ScreenPoint> points;
    Ink ink = {};
    bool closed = false;
    bool emphasised = false;
    double laid = 0; ///< pixels of the stroke that lie before its first point
};

/// A stroke along more pieces than it would be wise to lay out here.
struct ScenePieces {
    PieceStroke stroke; ///< all but its style
    Ink ink;
    std::size_t strokesBefore = 0; ///< strokes of the scene that lie beneath it
};

struct SceneMark {
    ScreenPoint at;
    SignShape shape = SignShape::disc;
    Ink ink;
    double angle = 0; ///< radians, clockwise on the screen
    double size = 1;  ///< of the role's usual size; small marks have no rim
};

/// Text near a place. "_" in the text lowers what follows, up to a space: "P_1,2".
struct SceneLabel {
    std::string text;
    ScreenPoint at;
    double clearance = 0; ///< how far the text stays from `at`, pixels
    Ink ink;
    bool optional = true; ///< left out where there is no room
    bool fixed = false;   ///< stands exactly at `at`, its middle line there
    bool noted = false;   ///< on a small plate, as a note
    double anchor = 0;    ///< if fixed: which part of its width lies left of `at`
};

struct SceneArea {
    ScreenRect rect;
    Ink ink;
};

/// One picture in one frame of the window.
struct Scene {
    ScreenRect frame;
    std::vector<SceneArea> areas;
    std::vector<SceneStroke> strokes;
    std::vector<ScenePieces> pieces;
    std::vector<SceneMark> marks;
    std::vector<SceneLabel> labels;
};

} // namespace splineloft::ui
