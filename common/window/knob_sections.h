// The panel's knobs in folding sections, one for each module.
#pragma once
#include <map>
#include <string>

#include "common/app/chapter.h"
#include "common/gpu/frame.h"
#include "common/window/knob_widgets.h"

namespace lightwalk {

/// Draws a filter field and the sections below it. Initially the chapter's own knobs and the module it teaches are
/// open, and borrowed modules closed; a person's changes persist in the chapter's next runs.
class KnobSections {
  public:
    explicit KnobSections(std::string chapter);

    /// True if a knob has changed. `times`: of the passes, for the costs beside sections and knobs.
    bool draw(Chapter& chapter, const std::vector<PassTime>& times, AutoChoices& automatic);

  private:
    bool section(const std::string& path, const KnobList& knobs, const std::vector<PassTime>& times,
                 AutoChoices& automatic);
    void remember(const std::string& path, bool open);
    std::string chapter_;
    std::map<std::string, bool> open_;  ///< by the module's path
    char filter_[64] = "";
};

/// Milliseconds of all passes named after a module: "shadow_map" and "clear_shadow" are the module `shadow`'s.
double module_ms(std::string_view module, const std::vector<PassTime>& times);

/// By section; empty if nothing was remembered or the file cannot be read. It lies in
/// $XDG_STATE_HOME/lightwalk, by default ~/.local/state/lightwalk.
std::map<std::string, bool> read_panel_memory(const std::string& chapter);

/// Leaves everything as it is where the file cannot be written: a read-only home is no reason to disturb anybody.
void write_panel_memory(const std::string& chapter, const std::map<std::string, bool>& open);

}  // namespace lightwalk
