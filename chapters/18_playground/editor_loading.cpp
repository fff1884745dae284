#include <fmt/core.h>

#include <algorithm>

#include "18_playground/commands.h"
#include "18_playground/editor_part.h"
#include "18_playground/file_browser.h"
#include "18_playground/widgets.h"
#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

constexpr double upload_ms = 8.0;  // of each frame

bool is_utf8(const std::string& text) {
    for (size_t i = 0, length = 0; i < text.size(); i += length)
        if (length = utf8_length(std::string_view(text).substr(i)); length == 0) return false;
    return true;
}

bool shows(const SceneObject& object, const fs::path& file) {
    return !object.model.empty() && !object.ground && !object.hidden && find_asset(object.model) == file;
}

bool has_model(const Scene& scene, const fs::path& file) {
    return std::any_of(scene.file.objects.begin(), scene.file.objects.end(),
                       [&](const SceneObject& object) { return shows(object, file); });
}

}  // namespace

// Resolves dependencies now, so that missing files are reported at once.
void LoadingPanel::want(const fs::path& file, bool adds) {
    try {
        if (!adds && editor.store.has_unsaved(editor.document))
            throw InputError("save first (Ctrl+S), or undo: {} was not opened", file.filename().string());
        Wanted one{.file = find_asset(file), .adds = adds, .ray = placing_ray(view_)};
        if (adds && !is_utf8(one.file.string()))
            throw InputError("{}: the path is not UTF-8, and a scene file holds nothing else; rename the file",
                             clean_name(one.file.filename().string()));
        if (one.file.extension() == ".json")
            for (const SceneObject& object : read_scene(one.file).objects) {
                if (object.model.empty() || object.hidden || is_height_map_file(object.model)) continue;
                const fs::path model = find_asset(object.model);
                if (std::find(one.models.begin(), one.models.end(), model) == one.models.end())
                    one.models.push_back(model);
            }
        else if (!adds || !has_model(scene, one.file))
            one.models.push_back(one.file);
        wanted_.push_back(std::move(one));
    } catch (const InputError& e) { editor.notice = e.what(); }
    view_.changed = true;
}

void LoadingPanel::stop(const std::string& why) {
    loading_.cancel();
    if (!wanted_.empty()) wanted_.pop_front();
    editor.notice = why;
    view_.changed = true;
}

void LoadingPanel::cancel() { stop("cancelled: " + wanted_.front().file.filename().string()); }

// [carry_on]
void LoadingPanel::carry_on() {
    if (!view_.gpu || wanted_.empty()) return;
    Gpu& gpu = *view_.gpu;
    Wanted& now = wanted_.front();
    if (auto ended = loading_.poll()) {
        if (!ended->model) return stop(ended->error);
        if (const std::string left_out = left_out_text(ended->model->model); !left_out.empty())
            editor.notice = clean_name(ended->file.filename().string()) + ": left out: " + left_out;
        now.arrived.push_back(std::make_unique<Arrival>(gpu, ended->file, std::move(*ended->model)));
        now.models.erase(now.models.begin());
    }
    if (loading_.busy() || (!now.arrived.empty() && !now.arrived.back()->step(upload_ms))) return;
    if (!now.models.empty()) return loading_.start(now.models.front());
    if (editor.drag) return;  // the scene stays unchanged under the mouse
    Wanted done = std::move(now);
    wanted_.pop_front();
    const Bounds box = box_of(done);
    view_.chapter.arrived = std::move(done.arrived);
    view_.changed = true;  // the panels of this frame were made before
    if (done.adds) {
        const Camera& camera = view_.chapter.camera;
        editor.add_model(done.file, placed_model(landing_on(scene, camera, done.ray, view_.terrain()), camera, box));
        log_event("added " + clean_name(done.file.filename().string()));
    } else {
        view_.chapter.opens = done.file;
    }
    remember_file(done.file);
}
// [/carry_on]

// In its own space: of the one that has arrived, or of the object that shows it already.
Bounds LoadingPanel::box_of(const Wanted& wanted) const {
    if (!wanted.arrived.empty()) return model_bounds(wanted.arrived.back()->model());
    for (const DrawItem& item : scene.items)
        if (shows(scene.file.objects[item.object], wanted.file)) return model_bounds(item.model->model);
    return {};
}

void LoadingPanel::draw() {
    if (wanted_.empty()) return;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float button = ImGui::CalcTextSize("cancel").x + 2.0f * style.FramePadding.x + style.ItemSpacing.x;
    const ImVec2 size{ImGui::GetContentRegionAvail().x - button, 0.0f};
    const Wanted& now = wanted_.front();
    if (loading_.busy() || now.arrived.empty())
        ImGui::ProgressBar(loading_.share(), size, loading_.words().c_str());
    else
        ImGui::ProgressBar(now.arrived.back()->share(), size, (now.file.filename().string() + ": uploading").c_str());
    ImGui::SameLine();
    if (tool_button("cancel", "Esc: the scene stays as it is")) cancel();
}

}  // namespace lightwalk
