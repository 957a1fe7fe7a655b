// Every difference between the versions of Dear ImGui, 1.86 to 1.92, in one place.
#pragma once

#include "ui/input.h"

#include <imgui.h>

namespace splineloft::ui {

/// Tells Dear ImGui of one event. Before 1.87 it had no queue of its own; our InputQueue does that
/// work, and here the event just becomes the present state.
void feed(ImGuiIO& io, const InputEvent& event);

/// Maps its navigation and editing keys to ours, where it does not know keys by name.
void mapKeys(ImGuiIO& io);

/// Whether arrow keys choose among what is drawn, and Enter takes it, from this frame on.
void followKeys(ImGuiIO& io, bool wanted);
/// Shows what Enter would take, before any arrow was pressed.
void showChosen();

/// Keys as Dear ImGui's own functions want them.
#if IMGUI_VERSION_NUM >= 18700
using ImGuiKeyCode = ImGuiKey;
#else
using ImGuiKeyCode = int;
#endif
ImGuiKeyCode escapeKey();
ImGuiKeyCode tabKey();
ImGuiKeyCode enterKey();
ImGuiKeyCode upKey();
ImGuiKeyCode downKey();

/// Whether the widget of that id is being held or edited.
bool isActiveWidget(unsigned id);

/// Whether a menu or list is open over the panels, and closing all that are.
bool isPopupOpen();
void closePopups();

/// Forgets which widget is being held, as Escape in mid-drag demands.
void releaseActiveWidget();

/// Ranges of characters that the interface shows: Latin, Greek, sub- and superscripts, arrows,
/// mathematical signs and shapes. Versions from 1.92 on load glyphs as they are needed.
const ImWchar* glyphRanges();

/// Draws the glyphs of an atlas, up to the pixels that renderers ask for. Versions from 1.92 on do
/// that when a renderer asks.
void drawGlyphs(ImFontAtlas& atlas);

} // namespace splineloft::ui
