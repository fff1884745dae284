#include "common/app/chapter.h"

#include "common/base/error.h"

namespace lightwalk {

void load_scene(Chapter& chapter, Gpu& gpu, const std::filesystem::path& given, const Loading& loading) {
    const auto loader = [&](const std::filesystem::path& file) { return chapter.load_model(file); };
    const std::filesystem::path file = find_asset(given);
    const bool is_scene = file.extension() == ".json";
    SceneFile scene = is_scene ? read_scene(file) : scene_of_model(file, {});
    const KnobList knobs = chapter.all_knobs();
    const bool anothers = !scene.knobs_of.empty() && scene.knobs_of != chapter.name;
    for (const auto& [name, value] : scene.knobs) try {
            if (KnobBase& knob = find_knob(knobs, name); !knob.pinned) knob.set(value);
        } catch (const InputError& e) {
            if (!anothers) throw InputError("{}: key 'knobs': {}", file.string(), e.what());
        }
    chapter.scene.file = scene;
    if (loading.before) loading.before();
    chapter.scene.load(gpu, std::move(scene), loader);
    // A bare model: now that its size is known, a camera that frames it. The pool keeps the model.
    if (!is_scene) chapter.scene.load(gpu, scene_of_model(file, chapter.scene.bounds), loader);
    chapter.camera = chapter.scene.file.camera;
    chapter.forget_history();
    chapter.prepare_all(gpu, chapter.scene);
    if (loading.after) loading.after(gpu);
}

}  // namespace lightwalk
