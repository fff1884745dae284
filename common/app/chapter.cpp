#include "common/app/chapter.h"

#include <fmt/format.h>

#include "common/app/foreign_scene.h"
#include "common/app/read_picture.h"
#include "common/app/render.h"
#include "common/base/error.h"
#include "common/base/text.h"
#include "common/scene/import.h"

namespace lightwalk {
namespace {

// Default scene for a bare model: camera, light, ground.
SceneFile furnished(const Chapter& chapter, const std::filesystem::path& file) {
    const Bounds bounds = chapter.scene.bounds;
    SceneFile scene = scene_of_model(file, bounds);
    if (chapter.scene.items.empty()) return scene;
    const Model& model = chapter.scene.items[0].model->model;
    if (chapter.camera_of_file > 0) use_camera_of_file(scene, model, static_cast<size_t>(chapter.camera_of_file));
    if (const std::string why = why_invisible(model, scene.camera.position); !why.empty())
        warn("{}: nothing of it is seen: {}", file.string(), why);
    if (chapter.camera_of_file == 0 && !(model.cameras.empty() && model.lights.empty()))
        warn_once(
            fmt::format("{}: left out: {} camera{} and {} light{} of the file; --camera-of-file 1 draws with them",
                        file.string(), model.cameras.size(), model.cameras.size() == 1 ? "" : "s", model.lights.size(),
                        model.lights.size() == 1 ? "" : "s"));
    if (!bounds.empty()) add_ground(scene, model);
    return scene;
}

constexpr glm::uvec2 looked_at{192, 108};  // test picture, in pixels
constexpr double most_clipped = 0.01;

// Dims the default scene of a bare model if more than 1% of its pixels are clipped. True: reload.
bool expose(Chapter& chapter, Gpu& gpu) {
    Frame frame(gpu);
    render(chapter, frame, {.size = looked_at, .crop = {}});
    const Image8 written = read_picture(gpu, chapter.written(frame));
    const auto white = std::count_if(written.pixels.begin(), written.pixels.end(), [](const glm::u8vec4& p) {
        return std::max({p.r, p.g, p.b}) == 255;
    });
    if (double(white) <= most_clipped * double(written.pixels.size())) return false;
    const ImageRgb picture = read_linear(gpu, frame.linear());
    std::vector<float> brightest;
    for (const glm::vec3& p : picture.pixels) brightest.push_back(std::max({p.r, p.g, p.b}));
    const auto place = static_cast<std::ptrdiff_t>(double(brightest.size()) * (1 - 0.5 * most_clipped));
    std::nth_element(brightest.begin(), brightest.begin() + place, brightest.end());
    const float bright = 1.02f * brightest[static_cast<size_t>(place)];  // maps to code 253
    if (!(bright > 1.0f && std::isfinite(bright))) return false;
    SceneFile& scene = chapter.scene.file;
    scene.emission /= bright;
    scene.ambient /= bright;
    scene.background /= bright;
    for (Light& light : scene.lights) light.intensity /= bright;
    return true;
}

}  // namespace

Chapter::Chapter() = default;

Chapter::~Chapter() = default;

void load_scene(Chapter& chapter, Gpu& gpu, const std::filesystem::path& given, const Loading& loading) {
    const std::filesystem::path file = find_asset(given);
    const bool is_scene = file.extension() == ".json";
    SceneFile scene = is_scene ? read_scene(file) : scene_of_model(file, {});
    const KnobList knobs = chapter.all_knobs();
    ForeignScene foreign(file, scene, chapter.name, "this chapter");
    foreign.set_knobs(scene, [&](const std::string& name) -> KnobBase& { return find_knob(knobs, name); });
    const auto loader = [&](const std::filesystem::path& model) {
        return foreign.model(chapter, model, [&] { return chapter.load_model(model); });
    };
    chapter.scene.file = scene;
    if (loading.before) loading.before();
    chapter.scene.load(gpu, std::move(scene), loader);
    // Second load, with a camera framing the bounds now known; the pool keeps the model.
    if (!is_scene) chapter.scene.load(gpu, furnished(chapter, file), loader);
    foreign.name_left_out();
    const auto prepare = [&] {
        chapter.camera = chapter.scene.file.camera;
        chapter.forget_history();
        chapter.prepare_all(gpu, chapter.scene);
    };
    prepare();
    // Films have no items.
    if (!is_scene && !chapter.scene.items.empty() && expose(chapter, gpu)) {
        chapter.scene.load(gpu, SceneFile(chapter.scene.file), loader);
        prepare();
    }
    if (loading.after) loading.after(gpu);
}

}  // namespace lightwalk
