#include "common/scene/model_pool.h"

#include "common/base/error.h"

namespace lightwalk {
namespace {

// Beyond, squares of distances leave a float's range, and the picture holds NaN.
constexpr float farthest_m = 1e15f;

std::string key_of_model(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::weakly_canonical(file, error).string();
}

}  // namespace

void check_extent(const Model& model, const std::filesystem::path& file) {
    for (const Mesh& mesh : model.meshes)
        for (int i = 0; i < 3; ++i)
            for (const float x : {mesh.bounds.lower[i], mesh.bounds.upper[i]})
                if (!mesh.bounds.empty() && !(std::abs(x) <= farthest_m))
                    throw InputError("{}: mesh '{}' has a position at {:g}, expected at most {:g} m", file.string(),
                                     mesh.name, x, farthest_m);
}

void ModelPool::put(const std::filesystem::path& file, const std::shared_ptr<GpuModel>& model) {
    models_.try_emplace(key_of_model(file), model);
}

std::shared_ptr<GpuModel> ModelPool::load(Gpu& gpu, const std::filesystem::path& file, const ModelLoader& loader) {
    std::shared_ptr<GpuModel>& entry = models_[key_of_model(file)];
    if (entry) return entry;
    auto model = std::make_shared<GpuModel>();
    model->model = loader(file);
    check_extent(model->model, file);
    model->nodes = world_transforms(model->model, 0.0f);
    for (const Mesh& mesh : model->model.meshes) {
        model->vertices.push_back(gpu.upload(mesh.name + " vertices", mesh.vertices));
        model->indices.push_back(gpu.upload(mesh.name + " indices", mesh.indices));
    }
    return entry = model;
}

}  // namespace lightwalk
