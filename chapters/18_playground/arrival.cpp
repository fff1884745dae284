#include "18_playground/arrival.h"

#include <algorithm>

#include "04_surface_maps/maps.h"
#include "04_surface_maps/tangents.h"

namespace lightwalk {

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
