#include "18_playground/preview.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "15_terrain_water/height_map.h"
#include "common/app/read_picture.h"
#include "common/app/render.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/names.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

constexpr double slice_ms = 4.0;
constexpr uintmax_t largest_file = uintmax_t{64} << 20;  // beyond it a thumbnail would take longer than a look

// In the light in which most things look their best.
void light_well(SceneFile& scene) {
    scene.environment.image = "environments/interior.hdr";
    scene.environment.where = "the preview's environment";
    scene.environment.intensity = 0.6f;
}

}  // namespace

Playground& Preview::chapter() {
    if (chapter_) return *chapter_;
    chapter_ = std::make_unique<Playground>();
    chapter_->name = "18_playground";
    chapter_->marks.on.value = false;
    chapter_->bench.light.prefilter.samples.value = 16;  // it is small
    return *chapter_;
}

Image8 Preview::draw(Gpu& gpu, const SceneFile& scene, glm::uvec2 size) {
    Playground& drawn = chapter();
    if (!frame_) frame_ = std::make_unique<Frame>(gpu);
    drawn.scene.load(gpu, scene, [&](const fs::path& file) { return drawn.load_model(file); });
    drawn.camera = drawn.scene.file.camera;
    drawn.prepare_all(gpu, drawn.scene);
    render(drawn, *frame_, {size, 0.0f, 0, {}});
    return read_picture(gpu, frame_->output);
}

SceneFile material_ball(const SceneObject& object, const DrawItem& item) {
    SceneFile scene;
    light_well(scene);
    SceneObject ball{.name = "ball", .parent = {}, .model = "models/sphere.obj", .material = object.material};
    MaterialOverride& material = ball.material;
    material.diffuse = item.material.diffuse;
    material.specular = item.material.specular;
    material.emissive = item.material.emissive;
    material.shininess = item.material.shininess;
    material.opacity = item.material.opacity;
    material.blend = item.material.blend;
    // Textures of the model's own material, where the scene names no others.
    const Material& own = own_material(item);
    for (size_t i = 0; i < map_slot_count; ++i)
        if (const MapSlotInfo& slot = map_slots()[i]; item.loaded_maps[i] && slot.from && own.*slot.from)
            material.maps.try_emplace(slot.name, (own.*slot.from).file);
    scene.objects.push_back(std::move(ball));
    scene.lights = {{.color = {1.0f, 0.96f, 0.9f}, .direction = glm::normalize(glm::vec3(-0.6f, -0.8f, -0.6f))}};
    scene.lights[0].intensity = 1.5f;
    scene.background = glm::vec3(0.02f);
    scene.camera.position = {0.35f, 0.25f, 2.0f};
    scene.camera.target = glm::vec3(0.0f);
    scene.camera.fov_y_rad = glm::radians(31.0f);
    return scene;
}

bool is_image(const fs::path& file) {
    static constexpr const char* endings[] = {".png", ".jpg", ".jpeg", ".hdr", ".tga", ".webp"};
    return std::ranges::find(endings, lowercase(file.extension().string())) != std::end(endings);
}

fs::path thumbnail_file(const fs::path& file) {
    const char* const cache = std::getenv("XDG_CACHE_HOME");
    const char* const home = std::getenv("HOME");
    if (!(cache && *cache) && !(home && *home)) return {};
    std::error_code error;
    const auto written = fs::last_write_time(file, error).time_since_epoch().count();
    const std::string key = fmt::format("{} {} {}", fs::absolute(file).string(), fs::file_size(file, error), written);
    return (cache && *cache ? fs::path(cache) : fs::path(home) / ".cache") / "lightwalk" / "thumbnails" /
           fmt::format("{:016x}.png", hash_bytes(key));
}

const Image8* Thumbnails::of(const fs::path& file) {
    if (const auto known = pictures_.find(file); known != pictures_.end())
        return known->second.width ? &known->second : nullptr;
    std::error_code error;
    if (const fs::path kept = thumbnail_file(file); !kept.empty() && fs::is_regular_file(kept, error)) try {
            return &(pictures_[file] = read_image8(kept));
        } catch (const InputError&) {}  // damaged: it is drawn again
    if (fs::file_size(file, error) > largest_file || error) {
        pictures_.try_emplace(file);
        return nullptr;
    }
    const auto waits = std::find(wanted_.begin(), wanted_.end(), file);
    if (waits == wanted_.end()) wanted_.insert(wanted_.begin(), file);
    return nullptr;
}

void Thumbnails::begin(const fs::path& file) {
    scene_ = file.extension() == ".json" ? read_scene(file) : scene_of_model(file, {});
    models_.clear();
    for (const SceneObject& object : scene_->objects)
        if (!object.model.empty() && !object.hidden && !is_height_map_file(object.model))
            models_.push_back(find_asset(object.model));
    std::sort(models_.begin(), models_.end());
    models_.erase(std::unique(models_.begin(), models_.end()), models_.end());
}

bool Thumbnails::carry_on(Gpu& gpu, Preview& preview) {
    if (wanted_.empty()) return false;
    const fs::path file = wanted_.back();
    const auto settle = [&](Image8 picture) {
        pictures_[file] = std::move(picture);
        wanted_.pop_back();
        scene_.reset();
        if (++drawn_ % 16 == 0) preview.forget();
        return true;
    };
    try {
        if (is_image(file)) return settle(thumbnail(read_image_linear(file), size));
        if (!scene_) begin(file);
        if (auto ended = loading_.poll()) {
            if (!ended->model) return settle({});
            if (file.extension() != ".json") {
                scene_ = scene_of_model(file, model_bounds(ended->model->model));
                light_well(*scene_);
            }
            arrival_ = std::make_unique<Arrival>(gpu, ended->file, std::move(*ended->model));
            models_.pop_back();
        }
        if (arrival_ && !arrival_->step(slice_ms)) return false;
        if (arrival_) preview.give(*std::exchange(arrival_, nullptr));
        if (loading_.busy()) return false;
        if (!models_.empty()) {
            loading_.start(models_.back());
            return false;
        }
        Image8 picture = preview.draw(gpu, *scene_, size);
        std::error_code error;
        if (const fs::path kept = thumbnail_file(file); !kept.empty()) {
            fs::create_directories(kept.parent_path(), error);
            if (!error) write_png(kept, picture);
        }
        return settle(std::move(picture));
    } catch (const InputError&) { return settle({}); }  // files that cannot be shown are still listed
}

}  // namespace lightwalk
