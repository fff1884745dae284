#include "common/scene/model_pool.h"

#include <algorithm>

#include "common/base/error.h"
#include "common/base/shared_lock.h"
#include "common/base/text.h"

namespace lightwalk {
namespace {

// Beyond this, squared distances overflow floats and produce NaN.
constexpr float farthest_m = 1e15f;

std::string key_of_model(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::weakly_canonical(file, error).string();
}

// Floats near x are |x| 2^-23 apart: where that is a ten-thousandth of a shape, its surface is drawn in steps.
void warn_if_far_off(const Model& model, const std::filesystem::path& file) {
    Bounds all;
    for (const Mesh& mesh : model.meshes) all.add(mesh.bounds);
    if (all.empty()) return;
    const glm::vec3 most = glm::max(glm::abs(all.lower), glm::abs(all.upper)), extent = all.extent();
    const float far_m = std::max({most.x, most.y, most.z}), size_m = std::max({extent.x, extent.y, extent.z});
    if (const float step_m = far_m * 0x1p-23f; step_m > 1e-4f * size_m && size_m > 0)
        warn(
            "{}: {:g} m from the origin floats are {:g} m apart, and its shape of {:g} m is drawn in such steps; "
            "subtract an "
            "offset from its coordinates",
            file.string(), far_m, step_m, size_m);
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

void pose_model(GpuModel& gpu_model, float time_s) {
    const Model& model = gpu_model.model;
    gpu_model.time_s = time_s;
    gpu_model.nodes = world_transforms(model, time_s);
    gpu_model.animated.clear();
    if (gpu_model.bounds_of.size() != model.meshes.size()) {
        gpu_model.bounds_of.clear();
        for (const Mesh& mesh : model.meshes) gpu_model.bounds_of.emplace_back(mesh);
    }
    gpu_model.poses.clear();
    for (size_t i = 0; i < model.meshes.size(); ++i) {
        const Mesh& mesh = model.meshes[i];
        MeshPose& pose = gpu_model.poses.emplace_back(MeshPose{.bounds = mesh.bounds});
        if (!mesh.deformation) continue;
        const MeshPose moved =
            gpu_model.bounds_of[i].at(morph_weights(model, mesh, time_s), joint_matrices(model, mesh, gpu_model.nodes));
        pose.mirrored = moved.mirrored;
        if (!model.motions.empty()) pose.bounds = moved.bounds;
    }
}

const std::vector<Vertex>& vertices_of(const GpuModel& model, uint32_t mesh) {
    const Mesh& of = model.model.meshes[mesh];
    if (!of.deformation || model.model.motions.empty()) return of.vertices;
    const auto [place, added] = model.animated.try_emplace(mesh);
    if (added) place->second = deformed(model.model, of, model.nodes, model.time_s);
    return place->second;
}

void upload_rare_attributes(Gpu& gpu, GpuModel& model) {
    const auto upload = [&](const char* binding, auto Mesh::*values) {
        const std::vector<Mesh>& meshes = model.model.meshes;
        if (std::all_of(meshes.begin(), meshes.end(), [&](const Mesh& mesh) { return (mesh.*values).empty(); })) return;
        std::vector<Buffer>& buffers = model.attributes[binding];
        buffers.clear();
        for (const Mesh& mesh : meshes) {
            const auto one = std::remove_cvref_t<decltype(mesh.*values)>(1);
            buffers.push_back(gpu.upload(mesh.name + " " + binding, (mesh.*values).empty() ? one : mesh.*values));
        }
    };
    upload("second_uvs", &Mesh::second_uvs);
    upload("vertex_colors", &Mesh::colors);
}

void ModelPool::put(const std::filesystem::path& file, const std::shared_ptr<GpuModel>& model) {
    models_.try_emplace(key_of_model(file), model);
}

std::shared_ptr<GpuModel> ModelPool::load(Gpu& gpu, const std::filesystem::path& file, const ModelLoader& loader) {
    std::shared_ptr<GpuModel>& entry = models_[key_of_model(file)];
    if (entry) return entry;
    auto model = std::make_shared<GpuModel>();
    model->model = unlocked([&] { return loader(file); });
    check_extent(model->model, file);
    warn_if_far_off(model->model, file);
    pose_model(*model, 0.0f);
    for (const Mesh& mesh : model->model.meshes) {
        model->vertices.push_back(gpu.upload(mesh.name + " vertices", mesh.vertices));
        model->indices.push_back(gpu.upload(mesh.name + " indices", mesh.indices));
    }
    upload_rare_attributes(gpu, *model);
    return entry = model;
}

}  // namespace lightwalk
