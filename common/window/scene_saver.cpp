#include "common/window/scene_saver.h"

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/own_files.h"
#include "common/window/event_log.h"

namespace lightwalk {
namespace fs = std::filesystem;

SceneSaver::SceneSaver(const Chapter& chapter, fs::path scene, Notice& notice)
    : chapter_(chapter), scene_(std::move(scene)), notice_(notice) {
    remember();
}

void SceneSaver::save() {
    SceneFile scene = chapter_.scene.file;
    scene.camera = chapter_.camera;
    for (const KnobBase* knob : chapter_.all_knobs()) scene.knobs[knob->path()] = knob->text();
    const bool own =
        scene_.extension() == ".json" && fs::exists(scene_) && !lies_below(scene_, course_root() / "assets");
    const fs::path path = own ? scene_ : saving_folder() / (chapter_.name.substr(0, 2) + "_scene.json");
    try {
        const uint64_t there = fs::exists(path) ? hash_bytes(read_file(path)) : 0;
        const bool known = there == 0 || there == (own ? read_ : saved_);
        if (!known && steady_s() > confirm_until_) {
            confirm_until_ = steady_s() + Notice::shown_s;
            notice_.tell(path.string() + (own ? " was edited since it was read" : " is there already") +
                         "; Ctrl+S again writes " + (own ? "camera and knobs into it" : "over it"));
            log_event("asks before saving " + fs::absolute(path).string());
            return;
        }
        own ? update_scene(scene, path) : write_scene(scene, path);
        (own ? read_ : saved_) = hash_bytes(read_file(path));
        confirm_until_ = 0;
        notice_.tell("scene: " + fs::absolute(path).string());
        log_event("saved " + fs::absolute(path).string());
    } catch (const InputError& e) {
        notice_.tell("not saved: " + std::string(e.what()));
        log_event("not saved");
    }
}

void SceneSaver::remember() {
    std::error_code error;
    read_ = fs::is_regular_file(scene_, error) ? hash_bytes(read_file(scene_)) : 0;
}

}  // namespace lightwalk
