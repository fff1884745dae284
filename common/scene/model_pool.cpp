#include "common/scene/model_pool.h"

namespace lightwalk {

std::shared_ptr<GpuModel> ModelPool::load(Gpu& gpu, const std::filesystem::path& file, const ModelLoader& loader) {
    std::error_code error;
    std::shared_ptr<GpuModel>& entry = models_[std::filesystem::weakly_canonical(file, error).string()];
    if (entry) return entry;
    auto model = std::make_shared<GpuModel>();
    model->model = loader(file);
    model->nodes = world_transforms(model->model, 0.0f);
    for (const Mesh& mesh : model->model.meshes) {
        model->vertices.push_back(gpu.upload(mesh.name + " vertices", mesh.vertices));
        model->indices.push_back(gpu.upload(mesh.name + " indices", mesh.indices));
    }
    return entry = model;
}

}  // namespace lightwalk
