#include "18_playground/background_load.h"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "01_obj/obj.h"
#include "04_surface_maps/maps.h"
#include "04_surface_maps/tangents.h"
#include "common/base/error.h"

namespace lightwalk {

namespace {

bool is_ready(const std::future<LoadedModel>& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

std::vector<LoadedTexture> decode_textures(const Model& model) {
    std::map<std::string, std::pair<TextureUse, bool>> wanted;  // by key; and whether it is a normal map
    for (const Material& material : model.materials)
        for (size_t slot = 0; slot < map_slot_count; ++slot)
            if (const auto use = texture_use(material, static_cast<MapSlot>(slot)))
                wanted.try_emplace(use->key(), *use, false).first->second.second |= map_slots()[slot].is_normal;
    progress()->begin("decoding textures", wanted.size());
    std::vector<LoadedTexture> textures;
    for (const auto& [key, texture] : wanted) {
        progress()->step(1);
        LoadedTexture one{texture.first, {}, {}};
        try {
            one.texels = decode_texture(one.use);
        } catch (const InputError&) { continue; }  // who draws it says so
        if (texture.second) one.normal_levels = normal_map_levels(one.texels);
        textures.push_back(std::move(one));
    }
    return textures;
}

}  // namespace

// [start]
void BackgroundLoad::start(const std::filesystem::path& file) {
    cancel();
    const auto shared = std::make_shared<Progress>();
    now_.emplace(Now{file, shared, std::async(std::launch::async, [file, shared] {
                         progress() = shared.get();
                         setpriority(PRIO_PROCESS, 0, 10);  // of this thread and its children
                         LoadedModel read{load_model(file), {}, {}};
                         check_extent(read.model, file);
                         read.frames = frame_model(read.model);
                         read.textures = decode_textures(read.model);
                         return read;
                     })});
}

void BackgroundLoad::cancel() {
    if (now_) {
        now_->progress->cancelled = true;
        dropped_.push_back(std::move(now_->read));  // a future waits for its thread when it goes
    }
    now_.reset();
    std::erase_if(dropped_, is_ready);
}
// [/start]

std::optional<BackgroundLoad::Ended> BackgroundLoad::poll() {
    if (!now_ || !is_ready(now_->read)) return {};
    Ended ended{now_->file, {}, ""};
    try {
        ended.model = now_->read.get();
    } catch (const std::exception& e) { ended.error = e.what(); }
    now_.reset();
    return ended;
}

float BackgroundLoad::share() const { return now_ ? std::clamp(now_->progress->share(), 0.0f, 1.0f) : 0.0f; }

std::string BackgroundLoad::words() const {
    if (!now_) return "";
    const char* const stage = now_->progress->stage.load();
    return fmt::format("{}: {} {:.0f}%", now_->file.filename().string(), *stage ? stage : "opening", 100.0f * share());
}

Arrival::Arrival(Gpu& gpu, std::filesystem::path file, LoadedModel read)
    : gpu_(gpu), file_(std::move(file)), read_(std::move(read)) {
    model_->model = std::move(read_.model);
    pose_model(*model_, 0.0f);
    const std::vector<Mesh>& meshes = model_->model.meshes;
    std::vector<Buffer>& tangents = model_->attributes["tangents"];
    for (std::vector<Buffer>* buffers : {&model_->vertices, &model_->indices, &tangents})
        buffers->resize(meshes.size());
    for (size_t i = 0; i < meshes.size(); ++i) {
        const Mesh& mesh = meshes[i];
        slices_.add(model_->vertices[i], mesh.name + " vertices", std::as_bytes(std::span(mesh.vertices)));
        slices_.add(model_->indices[i], mesh.name + " indices", std::as_bytes(std::span(mesh.indices)));
        slices_.add(tangents[i], tangents_name(mesh), std::as_bytes(std::span(read_.frames[i])));
        slices_.forget(read_.frames[i]);
    }
    upload_rare_attributes(gpu, *model_);
    const uint32_t most = gpu.device.properties.limits.maxImageDimension2D;
    for (LoadedTexture& texture : read_.textures) {
        Texture& own = textures_.emplace_back();
        const Image::Desc& desc = texture.texels.desc;
        if (std::max(desc.size.x, desc.size.y) > most) continue;  // the pool refuses it, and says so
        slices_.add(*(own.image = std::make_shared<Image>(gpu.device, desc)), texture.texels.levels);
        if (!texture.normal_levels.empty())
            slices_.add(*(own.normals = std::make_shared<Image>(gpu.device, desc)), texture.normal_levels);
        // Hundreds of megabytes given back in one frame would be seen.
        for (auto* levels : {&texture.texels.levels, &texture.normal_levels})
            for (std::vector<std::byte>& level : *levels) slices_.forget(level);
    }
}

void Arrival::give(Scene& scene) const {
    scene.models().put(file_, model_);
    ImagePool& images = scene.images(gpu_);
    for (size_t i = 0; i < textures_.size(); ++i) {
        const LoadedTexture& read = read_.textures[i];
        if (!textures_[i].image) continue;
        images.put(read.use, textures_[i].image, read.texels.channels);
        if (textures_[i].normals) images.derived[{textures_[i].image.get(), normal_levels_name}] = textures_[i].normals;
    }
}

}  // namespace lightwalk
