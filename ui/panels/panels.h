// The panels: each draws itself on its stage from the session as it is, and answers with what the
// person did: an edit of the document, changes of the view, a command.
#pragma once

#include "ui/canvas/gizmo.h"
#include "ui/canvas/motion_plot.h"
#include "ui/session.h"
#include "ui/stage.h"

#include <optional>

namespace splineloft::ui {

/// Menus drawn from the table of commands, and the name of the file.
void drawMenuBar(Session& session, const Stage& stage);

/// Buttons for the tools and layers, each a command.
void drawToolRail(Session& session, const Stage& stage);

/// Curves, family, parameters, ends, traits, joints, points.
std::optional<Edit> drawInspector(const Session& session, View& view, const Stage& stage);

/// The curves by name, with their looks.
std::optional<Edit> drawCurves(const Session& session, View& view, const Stage& stage);

/// The table of a curve's points, with their weights and local parameters.
std::optional<Edit> drawPoints(const Session& session, View& view, const Study& study,
                               const Stage& stage);

/// The box of several selected points in numbers, at the inspector's foot; how high that is.
double selectionHeight(const Stage& stage);
std::optional<Edit> drawSelection(const Session& session, const View& view, const PlaneBox& box,
                                  const Stage& stage);

/// The numbers of the point for which exact entry was asked, beside it on the canvas.
std::optional<Edit> drawExactEntry(const Session& session, View& view, const Stage& stage);

/// Where the plots are to be drawn: the one over the whole curve, and that of one piece where it is
/// of basis functions.
struct StripFrames {
    ScreenRect whole;
    std::optional<ScreenRect> segments;
    Caption caption = Caption::unit;
};
/// The strip of plots: its controls and values.
std::optional<StripFrames> drawStrip(const Session& session, View& view, const Stage& stage);

/// The messages, as long as they are wanted.
void drawLog(Session& session, const Stage& stage);

/// The submenu of recent files, within a menu.
void drawRecentMenu(Session& session);

/// What the mouse would do now, or the latest message; where the pointer is; length; zoom.
void drawStatus(const Session& session, const Stage& stage);

/// The canvas as a place for the hand: takes the frame's events, drives the gesture.
void drawCanvas(Session& session, const Stage& stage, std::span<const InputEvent> events);

/// In place of the status line before an audience: which curve, which family, which u.
void drawCaption(const Session& session, const Stage& stage);

/// The edges between canvas, inspector and strip: dragging moves them, a double click puts them
/// back. Before the panels beside them, for they lie over both.
void drawSplitters(View& view, const Layout& layout, const Screen& screen, const Theme& theme);

/// The menu that the right button has opened on the canvas, if it has.
void drawContextMenu(Session& session, const Stage& window);

/// The inside of the dialog that offers unsaved work of editors that died.
void drawRecoveryOffer(Session& session, const Stage& window);

/// The dialog that stands in front, if one does.
void drawDialog(Session& session, const Stage& window);

/// Begins a window that fills a stage and cannot be moved, with more of ImGuiWindowFlags if wanted.
/// Ends with ImGui::End().
void beginPanel(const char* name, const Stage& stage, int moreFlags = 0);

} // namespace splineloft::ui
