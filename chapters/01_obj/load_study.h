// Study and need rule of the loaders: megabytes per second against error, and the choice of a loader for a scene.
#pragma once
#include "01_obj/model_chapter.h"
#include "common/study/subject.h"

namespace lightwalk {

/// Measures files instead of frames.
struct LoaderSubject : Subject {
    LoaderSubject(const SceneFile& file_of_scene, Choice& loader_knob) : scene(file_of_scene), loader(loader_knob) {}

    /// Every loader on study["scenes"] (files, from the root; one that is missing is left out with a warning),
    /// study["rounds"] times each.
    void measure(const nlohmann::json& study, nlohmann::json& result) override;

    /// The fastest loader for the scene's .obj files with an error of at most `budget` ULP.
    nlohmann::json choose(double budget) override;

    const SceneFile& scene;
    Choice& loader;
};

}  // namespace lightwalk
