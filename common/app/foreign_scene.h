// Scenes saved by another chapter: parts unknown to the reader are skipped with a warning.
#pragma once
#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "common/app/module.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

/// State of one load. Scenes without knobs_of, or with the reader's own, must be complete.
class ForeignScene {
  public:
    /// `reader`: chapter name. `words`: its description in the warning, for instance "this chapter".
    ForeignScene(std::filesystem::path file, const SceneFile& scene, std::string reader, std::string words);

    /// Throws InputError if the name is unknown or ambiguous.
    using FindKnob = std::function<KnobBase&(const std::string& name)>;

    /// Applies knobs, except pinned ones and the other chapter's own, such as `method`. Throws InputError.
    void set_knobs(const SceneFile& scene, const FindKnob& find);

    /// Model from a module that handles the file (a height map), or from `load`; empty for unknown file types.
    Model model(const Module& reader, const std::filesystem::path& file, const std::function<Model()>& load);

    std::string left_out() const;

    void name_left_out() const;

  private:
    const std::filesystem::path file_;
    const std::string from_, words_;
    std::set<std::string> left_out_;
};

}  // namespace lightwalk
