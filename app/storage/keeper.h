// Everything that a sitting leaves on the disk: documents, settings, recent files, unsaved work;
// and the programs that it asks something. What the session requests is carried out here, and
// whatever goes wrong comes back to it in words.
#pragma once

#include "app/attendant.h"
#include "app/end_signal.h"
#include "app/storage/autosave.h"
#include "app/storage/places.h"
#include "app/storage/settings_file.h"
#include "app/storage/system_dialog.h"

#include <deque>
#include <string>
#include <vector>

namespace splineloft::app {

class Keeper : public Attendant {
  public:
    /// When `ending` has come, what is unsaved is kept, for the next start to offer, and the
    /// program ends.
    explicit Keeper(Places places, AutosavePace pace = {}, const EndSignal* ending = nullptr);

    /// At the start: gives the session its settings, shortcuts and recent files, and offers it the
    /// unsaved work of editors that died. `opened` are the files that it begins with.
    void begin(ui::Session& session, const std::vector<std::string>& opened);

    bool afterFrame(ui::Session& session, const ui::Screen& screen) override;
    bool attend(ui::Session& session) override;
    double patience() const override;

  private:
    bool mustEnd() const { return ending_ != nullptr && ending_->hasCome(); }
    void finish(ui::Session& session);
    void readShortcuts(ui::Session& session) const;
    void offerUnsavedWork(ui::Session& session);

    bool carryOutRequests(ui::Session& session);
    void carryOut(ui::Session& session, const ui::OpenFiles& request);
    void carryOut(ui::Session& session, const ui::SaveFile& request);
    void carryOut(ui::Session& session, const ui::ExportSamples& request);
    void carryOut(ui::Session& session, const ui::AskForFile& request);
    void carryOut(ui::Session& session, const ui::LookForRecent& request);
    void carryOut(ui::Session& session, const ui::ForgetRecent& request);
    void carryOut(ui::Session& session, const ui::RestoreWork& request);
    void carryOut(ui::Session& session, const ui::DiscardWork& request);
    void carryOut(ui::Session& session, const ui::ReadShortcuts& request);
    void carryOut(ui::Session& session, const ui::MakeShortcutsFile& request);
    void carryOut(ui::Session& session, const ui::Quit& request);

    void noteRecent(ui::Session& session, const std::string& path);
    bool attendRecent(ui::Session& session);
    bool attendDialog(ui::Session& session);
    /// Takes work off the list; nothing where it is not on it any more.
    std::optional<FoundWork> take(ui::Session& session, const std::string& id);

    Places places_;
    const EndSignal* ending_;
    SettingsFile settings_;
    Autosave autosave_;
    SystemDialog dialog_;
    std::vector<FoundWork> found_;
    std::deque<std::string> toNote_; ///< files that are not in the list on the disk yet
    Writer recentWriter_;
    bool news_ = false; ///< there is something new that no frame has shown
    bool ended_ = false;
};

} // namespace splineloft::app
