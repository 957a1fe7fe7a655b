// Undo: the document as last settled, and as it is on the screen while a hand is still moving.
#pragma once

#include "core/document/document.h"

#include <deque>
#include <string>
#include <string_view>

namespace splineloft {

/// One drag is one step: previews change only what is live, a commit settles it. A commit that
/// changes nothing leaves no step. Beyond 2,000 steps, or so many bytes of curves that no other
/// step shares, the oldest steps are forgotten; the last one never is.
class History {
  public:
    static constexpr std::size_t usualBytes = 512U << 20;

    explicit History(Document document = {}, std::size_t mostBytes = usualBytes);

    /// The document as of the last finished edit.
    const Document& settled() const { return states_[now_].document; }
    /// The document on the screen: a preview while one is under way, otherwise the settled one.
    const Document& live() const { return previewing_ ? preview_ : settled(); }
    bool previewing() const { return previewing_; }

    void preview(Document next);
    void cancel();
    /// Ends any preview. Returns whether a step was made.
    bool commit(Document next, std::string label);

    bool canUndo() const { return now_ > 0; }
    bool canRedo() const { return now_ + 1 < states_.size(); }
    /// Names of the steps that undo and redo would take, e.g. "Move P3"; empty where there is none.
    std::string_view undoLabel() const;
    std::string_view redoLabel() const;
    /// Both end a preview first by cancelling it.
    void undo();
    void redo();

  private:
    struct State {
        Document document;
        std::string label;     ///< of the step that led here
        std::size_t bytes = 0; ///< of its curves that the state before does not have
    };

    void forgetOldest();

    static constexpr std::size_t mostSteps = 2000;

    std::size_t mostBytes_;
    std::size_t bytes_ = 0; ///< of all states
    std::deque<State> states_;
    std::size_t now_ = 0;
    Document preview_;
    bool previewing_ = false;
};

} // namespace splineloft
