// Scenes that another chapter saved: parts that their reader lacks are passed over, and named in one line.
#pragma once
#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "common/app/module.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

/// For one load. A scene without knobs_of, or with the reader's own, may lack nothing.
class ForeignScene {
  public:
    /// `reader`: the chapter's name; `words`: for the line, such as "this chapter".
    ForeignScene(std::filesystem::path file, const SceneFile& scene, std::string reader, std::string words);

    /// Throws InputError for a name that is unknown or unclear.
    using FindKnob = std::function<KnobBase&(const std::string& name)>;

    /// Sets the scene's knobs, except for pinned ones. Throws InputError for a value that a knob refuses. In another
    /// chapter's scene only a module's knob is known to be the same one: `method` is each chapter's own.
    void set_knobs(const SceneFile& scene, const FindKnob& find);

    /// What a module stands for, such as a height map, or what `load` reads; empty for an unknown kind of file.
    Model model(const Module& reader, const std::filesystem::path& file, const std::function<Model()>& load);

    std::string left_out() const;  ///< modules and files, joined by commas

    /// Warns, once for each file.
    void name_left_out() const;

  private:
    const std::filesystem::path file_;
    const std::string from_, words_;  ///< from_: another chapter; empty: none
    std::set<std::string> left_out_;
};

}  // namespace lightwalk
