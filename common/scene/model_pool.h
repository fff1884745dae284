// Model cache: each file is loaded and uploaded once.
#pragma once
#include <functional>
#include <map>
#include <memory>

#include "common/gpu/gpu.h"
#include "common/scene/mesh.h"

namespace lightwalk {

using ModelLoader = std::function<Model(const std::filesystem::path&)>;

struct DeformBuffers {
    size_t vertices = 0;
    Buffer rest, offsets, weights, joints, joint_weights, matrices, moved;
};

/// Model with device buffers, one vertex and one index buffer per mesh.
struct GpuModel {
    Model model;
    std::vector<Buffer> vertices, indices;
    std::vector<glm::mat4> nodes;

    /// Extra vertex attributes of chapters: a buffer per mesh, by binding name.
    std::map<std::string, std::vector<Buffer>> attributes;
    std::vector<DeformBuffers> deformed;
};

void upload_rare_attributes(Gpu& gpu, GpuModel& model);

/// Throws InputError if coordinates exceed the drawable range.
void check_extent(const Model& model, const std::filesystem::path& file);

class ModelPool {
  public:
    std::shared_ptr<GpuModel> load(Gpu& gpu, const std::filesystem::path& file, const ModelLoader& loader);
    void put(const std::filesystem::path& file, const std::shared_ptr<GpuModel>& model);
    void clear() { models_.clear(); }
    size_t size() const { return models_.size(); }

  private:
    std::map<std::string, std::shared_ptr<GpuModel>> models_;
};

}  // namespace lightwalk
