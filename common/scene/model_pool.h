// Models on the device, each loaded and uploaded once.
#pragma once
#include <functional>
#include <map>
#include <memory>

#include "common/gpu/gpu.h"
#include "common/scene/mesh.h"

namespace lightwalk {

using ModelLoader = std::function<Model(const std::filesystem::path&)>;

/// Device buffers that deform a mesh.
struct DeformBuffers {
    size_t vertices = 0;  ///< that they are made for
    Buffer rest, offsets, weights, joints, joint_weights, matrices, moved;
};

/// A model as loaded and its buffers: for each mesh one of vertices and one of indices.
struct GpuModel {
    Model model;
    std::vector<Buffer> vertices, indices;
    std::vector<glm::mat4> nodes;  ///< into the model's space, at the time the scene was placed for

    /// A chapter's additional vertex attributes: by binding, a buffer for each mesh.
    std::map<std::string, std::vector<Buffer>> attributes;
    std::vector<DeformBuffers> deformed;  ///< of each mesh; empty if none moves
};

/// The attributes `second_uvs` and `vertex_colors`, where a mesh of the model has them.
void upload_rare_attributes(Gpu& gpu, GpuModel& model);

/// Throws InputError if the model reaches farther than can be drawn.
void check_extent(const Model& model, const std::filesystem::path& file);

/// Models by file.
class ModelPool {
  public:
    /// Passes on the loader's exceptions.
    std::shared_ptr<GpuModel> load(Gpu& gpu, const std::filesystem::path& file, const ModelLoader& loader);
    /// Adds a model with filled buffers for load() to find; check_extent() must have accepted it.
    void put(const std::filesystem::path& file, const std::shared_ptr<GpuModel>& model);
    void clear() { models_.clear(); }
    size_t size() const { return models_.size(); }

  private:
    std::map<std::string, std::shared_ptr<GpuModel>> models_;
};

}  // namespace lightwalk
