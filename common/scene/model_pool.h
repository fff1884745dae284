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
    std::string frames;  ///< name of the buffer of tangent frames that these derivatives made
    Buffer rest, offsets, weights, joints, joint_weights, matrices, flat, derivatives, moved, moved_frames;
};

/// Model with device buffers, one vertex and one index buffer per mesh.
struct GpuModel {
    Model model;
    std::vector<Buffer> vertices, indices;
    std::vector<glm::mat4> nodes;  ///< to model space
    std::vector<MeshPose> poses;   ///< per mesh
    float time_s = 0;              ///< of `nodes` and `poses`

    /// Extra vertex attributes of chapters: a buffer per mesh, by binding name.
    std::map<std::string, std::vector<Buffer>> attributes;
    std::vector<DeformBuffers> deformed;

    std::vector<DeformedBounds> bounds_of;                     ///< per mesh, of animated models
    mutable std::map<uint32_t, std::vector<Vertex>> animated;  ///< meshes at time_s: see vertices_of()
};

/// Sets nodes and meshes' bounds of an animated model. Its vertices follow with deform_model().
void pose_model(GpuModel& model, float time_s);

/// Vertices of a mesh in the model's present pose, for work on the processor.
const std::vector<Vertex>& vertices_of(const GpuModel& model, uint32_t mesh);

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
