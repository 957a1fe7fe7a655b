#include "ui/frame.h"

#include "ui/canvas/illustrate.h"
#include "ui/commands.h"
#include "ui/imgui_compat.h"
#include "ui/lettering.h"
#include "ui/paint.h"
#include "ui/panels/panels.h"
#include "ui/refit.h"
#include "ui/travel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace splineloft::ui {
namespace {

constexpr double longestStep = 0.1; // seconds

/// Keys that belong to a text field while one is being edited: with Ctrl the clipboard's, its own
/// undo and redo, and those that go or delete by words.
bool isForTextField(const Shortcut& shortcut) {
    if (!shortcut.modifiers.control) {
        return true;
    }
    constexpr std::array fieldKeys = {Key::a,         Key::c,   Key::v,    Key::x,
                                      Key::y,         Key::z,   Key::left, Key::right,
                                      Key::backspace, Key::del, Key::home, Key::end};
    return std::ranges::find(fieldKeys, shortcut.key) != fieldKeys.end();
}

bool isPress(const InputEvent& event) {
    const auto* button = std::get_if<PointerButton>(&event);
    const auto* key = std::get_if<KeyChanged>(&event);
    return (button != nullptr && button->down) || (key != nullptr && key->down);
}

/// A key that served nothing while it was down was tapped.
void endTap(Session& session, Key key) {
    const auto held = session.heldKey;
    if (held && held->key == key) {
        session.heldKey.reset();
        if (!held->served && !session.dialog) {
            runShortcut(session, {held->key, held->modifiers}, Strike::tap);
        }
    }
}

/// The shortcut that a key means now: in mid-drag Escape restores, whatever else is held down.
Shortcut shortcutOf(const KeyChanged& key, const Session& session) {
    const bool restores = key.key == Key::escape && !std::holds_alternative<Idle>(session.gesture);
    return {key.key, restores ? Modifiers{} : key.modifiers};
}

/// Keys, dropped files and the wish to close, which belong to no panel. Returns the shortcuts that
/// must wait until the panels are drawn: what was being typed there is entered first. `menuOpen`
/// says whether a menu or list was open when they came; it has taken the keys.
std::vector<Shortcut> takeEvents(Session& session, std::span<const InputEvent> events,
                                 bool menuOpen) {
    std::vector<Shortcut> waiting;
    for (const auto& event : events) {
        if (isPress(event)) {
            session.notice.reset();
        }
        if (const auto* dropped = std::get_if<FilesDropped>(&event);
            dropped && !dropped->paths.empty()) {
            session.leave(GoToFiles{dropped->paths});
        } else if (std::holds_alternative<CloseAsked>(event)) {
            session.leave(Quit{});
        } else if (const auto* focus = std::get_if<FocusChanged>(&event);
                   focus && !focus->focused) {
            session.heldKey.reset();
        } else if (const auto* key = std::get_if<KeyChanged>(&event); key && !key->down) {
            endTap(session, key->key);
        } else if (key != nullptr) {
            const Shortcut shortcut = shortcutOf(*key, session);
            if (menuOpen && !session.dialog) {
                if (key->key == Key::escape) {
                    closePopups();
                }
                continue;
            }
            const auto& io = ImGui::GetIO();
            if (io.WantTextInput && !session.dialog && !isForTextField(shortcut)) {
                if (hasCommand(session, shortcut)) {
                    releaseActiveWidget();
                    waiting.push_back(shortcut);
                }
                continue;
            }
            const bool typing = io.WantTextInput;
            const bool holding = ImGui::IsAnyItemActive() && !io.WantTextInput &&
                                 std::holds_alternative<Idle>(session.gesture);
            if (!typing && !holding && !session.dialog) {
                if (!key->repeat) {
                    session.heldKey = HeldKey{key->key, key->modifiers};
                }
                runShortcut(session, shortcut, key->repeat ? Strike::repeated : Strike::fresh);
            }
        }
    }
    return waiting;
}

/// Moves the cursor along the active curve while it plays; from the end back to the start.
void advance(Session& session, double seconds) {
    auto& view = session.view;
    const Study* study = session.active();
    if (!view.playing || study == nullptr || study->pieces().empty()) {
        view.playing = false;
        return;
    }
    // The first frame after a long sleep is no leap.
    travel(session, std::min(seconds, longestStep) / view.duration);
}

/// The note at the joint under the pointer.
void addJointNote(Scene& scene, const Session& session, double scale) {
    const Study* study = session.active();
    if (study == nullptr || !session.pointerOnCanvas ||
        !session.document().curves[session.view.activeCurve].look.visible) {
        return;
    }
    const Viewport viewport{session.view.camera, session.canvas};
    if (const auto joint = jointNear(*study, session.view, viewport, session.pointer, 12 * scale)) {
        const auto& found = study->traits().joints[*joint];
        const Point p = study->plane(session.view.axes).position({found.after, 0});
        scene.labels.insert(scene.labels.begin(), {describe(found),
                                                   viewport.toScreen({p[0], p[1]}),
                                                   18 * scale,
                                                   {Role::jointNote},
                                                   false,
                                                   false,
                                                   true});
    }
}

Emphasis emphasisOf(const View& view) {
    if (view.hovered && view.hovered->curve == view.activeCurve) {
        return {view.hovered->index};
    }
    return view.selection.size() == 1 ? Emphasis{view.selection.begin()->index} : Emphasis{};
}

/// Draws a scene: its picture for the renderer, its labels through Dear ImGui beneath the panels.
void show(FrameResult& result, const Scene& scene, const Theme& theme, Colour background,
          double scale) {
    result.pictures.push_back(paint(scene, theme, background, scale));
    drawLabels(*ImGui::GetBackgroundDrawList(), scene, theme, background, scale);
}

void showCanvas(FrameResult& result, const Session& session, const Theme& theme, double scale) {
    const Situation situation{session.history.settled(),
                              session.history.live(),
                              session.studies,
                              {session.view.camera, session.canvas},
                              scale};
    Scene scene = illustrate(session.view, session.gesture, situation);
    addJointNote(scene, session, scale);
    show(result, scene, theme, theme.surfaces.canvas, scale);
}

void drawBasisPlots(Scene& scene, const Study& study, const View& view, const StripFrames& frames,
                    double scale) {
    const auto emphasis = emphasisOf(view);
    drawBasis(scene, wholeRangeFrame(study, frames.whole), study, view.cursor, emphasis, scale);
    drawSegments(scene, segmentFrame(study, *frames.segments), study, view.cursor, emphasis, scale);
}

void showPlots(FrameResult& result, const Session& session, const StripFrames& frames,
               const ScreenRect& strip, const Theme& theme, double scale) {
    const Study* study = session.active();
    if (study == nullptr || study->pieces().empty()) {
        return;
    }
    const auto& view = session.view;
    Scene scene;
    scene.frame = strip;
    if (const auto plot = motionPlot(*study, view, frames.whole)) {
        drawMotion(scene, *plot, frames.caption, scale);
    } else if (frames.segments && study->blends() != nullptr) {
        drawBasisPlots(scene, *study, view, frames, scale);
    }
    show(result, scene, theme, theme.surfaces.panel, scale);
}

/// Whether Space is held down, so that a press would move the view.
bool canPan(const Session& session) {
    return session.heldKey && session.heldKey->key == Key::space;
}

PointerShape gripShape(const Grip& grip) {
    return grip.up == 0 && !grip.turns()       ? PointerShape::resizeAcross
           : grip.across == 0 && !grip.turns() ? PointerShape::resizeAlong
                                               : PointerShape::hand;
}

PointerShape pointerFor(const Session& session) {
    if (session.pointerOnCanvas) {
        const bool pans = std::holds_alternative<Panning>(session.gesture) || canPan(session);
        return pans                                ? PointerShape::move
               : session.view.tool != Tool::select ? PointerShape::cross
               : session.view.hovered || session.view.ghost || session.view.hoversStem
                   ? PointerShape::hand
               : session.view.hoveredGrip ? gripShape(*session.view.hoveredGrip)
                                          : PointerShape::arrow;
    }
    switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_TextInput: return PointerShape::text;
    case ImGuiMouseCursor_ResizeEW: return PointerShape::resizeAcross;
    case ImGuiMouseCursor_ResizeNS: return PointerShape::resizeAlong;
    case ImGuiMouseCursor_Hand: return PointerShape::hand;
    default: return PointerShape::arrow;
    }
}

/// What a person did in a panel.
void carryOut(Session& session, std::optional<Edit> edit) {
    if (edit) {
        const bool cancels = edit->phase == Phase::cancel;
        session.apply(std::move(*edit));
        if (cancels) {
            releaseActiveWidget();
        }
    }
}

/// Tab moves among fields while one is typed in; otherwise it goes through the points, and the
/// panel that was clicked last must not hear it as well.
bool isForPoints(const InputEvent& event, const Session& session) {
    const auto* key = std::get_if<KeyChanged>(&event);
    return key != nullptr && key->key == Key::tab && key->down && !session.dialog &&
           !isPopupOpen() && !ImGui::GetIO().WantTextInput;
}

/// Whether arrows and Enter choose among what stands in front: the entries of a menu or list, or
/// the answers to a question. (File names and the palette are typed in.)
bool takesKeys(const Session& session) {
    return session.dialog ? std::holds_alternative<UnsavedQuestion>(*session.dialog) ||
                                std::holds_alternative<RecoveryOffer>(*session.dialog)
                          : isPopupOpen();
}

void beginImGui(const Session& session, const Screen& screen, std::span<const InputEvent> events,
                double seconds) {
    auto& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(screen.width), static_cast<float>(screen.height)};
    io.DeltaTime = std::max(static_cast<float>(seconds), 1e-4F);
    for (const auto& event : events) {
        if (!isForPoints(event, session)) {
            feed(io, event);
        }
    }
    followKeys(io, takesKeys(session));
    ImGui::NewFrame();
}

/// Everything around the canvas and what happens on it; returns where the plots are to be drawn.
std::optional<StripFrames> drawPanels(Session& session, const Screen& screen, const Layout& layout,
                                      std::span<const InputEvent> events) {
    const Theme& theme = themeOf(session.view.theme);
    const auto stage = [&](const ScreenRect& rect) { return Stage{theme, screen.scale, rect}; };
    const bool panels = !session.view.presenting;
    drawSplitters(session.view, layout, screen, theme);
    if (panels) {
        drawToolRail(session, stage(layout.tools));
    }
    std::optional<StripFrames> frames;
    if (panels && session.view.log) {
        drawLog(session, stage(layout.strip));
    } else {
        frames = drawStrip(session, session.view, stage(layout.strip));
    }
    if (panels) {
        carryOut(session, drawInspector(session, session.view, stage(layout.inspector)));
    }
    carryOut(session, drawExactEntry(session, session.view, stage(layout.canvas)));
    // After the panels: what was typed there is entered by the press that acts here.
    drawCanvas(session, stage(layout.canvas), events);
    if (panels) {
        drawStatus(session, stage(layout.status));
        drawMenuBar(session, stage(layout.menu));
    } else {
        drawCaption(session, stage(layout.status));
    }
    const Stage window =
        stage({0, 0, static_cast<double>(screen.width), static_cast<double>(screen.height)});
    drawContextMenu(session, window);
    drawDialog(session, window);
    return frames;
}

} // namespace

FrameResult runFrame(Session& session, const Screen& window, std::span<const InputEvent> events,
                     double seconds) {
    const Screen screen = scaled(window, session.view); // what happens in it counts from the next
    const Theme& theme = themeOf(session.view.theme);
    applyStyle(theme, screen.scale);
    const bool menuOpen = isPopupOpen();
    beginImGui(session, screen, events, seconds);
    const auto waiting = takeEvents(session, events, menuOpen);
    advance(session, seconds);

    const auto layout = layOut(screen, session.view);
    followScreen(session, screen.scale, layout.canvas);
    const auto frames = drawPanels(session, screen, layout, events);
    for (const auto& shortcut : waiting) {
        runShortcut(session, shortcut);
    }
    fitIfAsked(session);

    FrameResult result;
    result.background = theme.surfaces.canvas;
    showCanvas(result, session, theme, screen.scale);
    if (frames) {
        showPlots(result, session, *frames, layout.strip, theme, screen.scale);
    }
    ImGui::Render();
    result.animating = session.view.playing;
    result.fullScreen = session.view.presenting;
    result.pointer = pointerFor(session);
    result.title = session.fileName() + (session.unsaved() ? " ●" : "") + " - Splineloft";
    return result;
}

} // namespace splineloft::ui
