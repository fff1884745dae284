// Mesh deformation on the device.
#include "common/scene/scene.h"

namespace lightwalk {
namespace {

const Pipeline deform = compute({.shader = "common/deform.comp"});

// Layout: per target, all positions, then all normals.
std::vector<glm::vec3> offsets_of(const Deformation& how) {
    std::vector<glm::vec3> offsets;
    for (const MorphTarget& target : how.targets) {
        offsets.insert(offsets.end(), target.positions.begin(), target.positions.end());
        offsets.insert(offsets.end(), target.normals.begin(), target.normals.end());
        if (target.normals.empty()) offsets.resize(offsets.size() + how.rest.size(), glm::vec3(0));
    }
    if (offsets.empty()) offsets.emplace_back(0.0f);  // placeholder: buffers cannot be empty
    return offsets;
}

template <class T>
std::vector<T> or_one(std::vector<T> list, T one) {
    if (list.empty()) list.push_back(one);
    return list;
}

void prepare(Gpu& gpu, const Mesh& mesh, DeformBuffers& buffers) {
    const Deformation& how = mesh.deformation;
    if (buffers.vertices == how.rest.size()) return;
    buffers.vertices = how.rest.size();
    buffers.moved = Buffer(gpu.device, {.name = mesh.name + " deformed", .bytes = how.rest.size() * sizeof(Vertex)});
    buffers.rest = gpu.upload(mesh.name + " at rest", how.rest);
    buffers.offsets = gpu.upload(mesh.name + " morph targets", offsets_of(how));
    buffers.joints = gpu.upload(mesh.name + " joints", or_one(how.joints, glm::uvec4(0)));
    buffers.joint_weights = gpu.upload(mesh.name + " joint weights", or_one(how.joint_weights, glm::vec4(0)));
}

}  // namespace

void deform_model(Frame& frame, GpuModel& gpu_model, float time_s) {
    const Model& model = gpu_model.model;
    gpu_model.deformed.resize(model.meshes.size());
    for (size_t i = 0; i < model.meshes.size(); ++i) {
        const Mesh& mesh = model.meshes[i];
        const Deformation& how = mesh.deformation;
        if (!how) continue;
        DeformBuffers& buffers = gpu_model.deformed[i];
        prepare(frame.gpu, mesh, buffers);
        frame.upload("morph weights", buffers.weights, or_one(morph_weights(model, mesh, time_s), 0.0f));
        const bool has_skin = !how.joints.empty();
        frame.upload("joint matrices", buffers.matrices,
                     has_skin ? joint_matrices(model, mesh, gpu_model.nodes) : std::vector(1, glm::mat4(1.0f)));
        const glm::uvec3 numbers(how.rest.size(), how.targets.size(), has_skin);
        frame.compute("deform",
                      {.reads = {buffers.rest, buffers.offsets, buffers.weights, buffers.joints, buffers.joint_weights,
                                 buffers.matrices},
                       .writes = {buffers.moved}},
                      [&](Compute& pass) {
                          pass.use(deform).set("rest", buffers.rest).set("vertices", buffers.moved);
                          pass.set("offsets", buffers.offsets).set("morph_weights", buffers.weights);
                          pass.set("joints", buffers.joints).set("joint_weights", buffers.joint_weights);
                          pass.set("joint_matrices", buffers.matrices).set("deform", numbers);
                          pass.dispatch_threads({numbers.x, 1});
                      });
        // As a transfer, which leaves the vertices readable by every later pass.
        frame.transfer("deformed", {.reads = {buffers.moved}, .writes = {gpu_model.vertices[i]}},
                       [&](VkCommandBuffer commands) {
                           const VkBufferCopy region{.size = how.rest.size() * sizeof(Vertex)};
                           vkCmdCopyBuffer(commands, buffers.moved.handle, gpu_model.vertices[i].handle, 1, &region);
                       });
    }
}

}  // namespace lightwalk
