// Mesh deformation on the device.
#include <utility>

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
    buffers.flat = gpu.upload(mesh.name + " flat corners", or_one(how.flat, glm::uvec3(0)));
}

// Derivatives of the tangent frames in use. `frames`: null where there are none.
void prepare_frames(Gpu& gpu, const Mesh& mesh, const Buffer* frames, DeformBuffers& buffers) {
    const std::string name = frames ? frames->name : "none";
    if (std::exchange(buffers.frames, name) == name) return;
    const size_t count = frames ? mesh.deformation.rest.size() : 1;
    buffers.derivatives = gpu.upload(mesh.name + " derivatives", or_one(mesh.deformation.derivatives, Derivatives{}));
    buffers.moved_frames =
        Buffer(gpu.device, {.name = mesh.name + " deformed frames", .bytes = count * sizeof(TangentFrame)});
}

// As a transfer, which leaves the copy readable by every later pass.
void copy(Frame& frame, const Buffer& from, const Buffer& into) {
    frame.transfer("deformed", {.reads = {from}, .writes = {into}}, [&](VkCommandBuffer commands) {
        const VkBufferCopy region{.size = from.bytes};
        vkCmdCopyBuffer(commands, from.handle, into.handle, 1, &region);
    });
}

// As common/deform.comp has it.
struct DeformBlock {
    uint32_t count, targets, has_skin, has_flat, has_frames;
};

}  // namespace

void deform_model(Frame& frame, GpuModel& gpu_model, float time_s) {
    const Model& model = gpu_model.model;
    gpu_model.deformed.resize(model.meshes.size());
    const auto known = gpu_model.attributes.find("tangents");
    for (size_t i = 0; i < model.meshes.size(); ++i) {
        const Mesh& mesh = model.meshes[i];
        const Deformation& how = mesh.deformation;
        if (!how) continue;
        DeformBuffers& buffers = gpu_model.deformed[i];
        const bool has_frames = known != gpu_model.attributes.end() && !how.derivatives.empty();
        prepare(frame.gpu, mesh, buffers);
        prepare_frames(frame.gpu, mesh, has_frames ? &known->second[i] : nullptr, buffers);
        frame.upload("morph weights", buffers.weights, or_one(morph_weights(model, mesh, time_s), 0.0f));
        const bool has_skin = !how.joints.empty();
        frame.upload("joint matrices", buffers.matrices,
                     or_one(joint_matrices(model, mesh, gpu_model.nodes), glm::mat4(1.0f)));
        const DeformBlock numbers{static_cast<uint32_t>(how.rest.size()), static_cast<uint32_t>(how.targets.size()),
                                  has_skin, !how.flat.empty(), has_frames};
        frame.compute("deform",
                      {.reads = {buffers.rest, buffers.offsets, buffers.weights, buffers.joints, buffers.joint_weights,
                                 buffers.matrices, buffers.flat, buffers.derivatives},
                       .writes = {buffers.moved, buffers.moved_frames}},
                      [&](Compute& pass) {
                          pass.use(deform).set("rest", buffers.rest).set("vertices", buffers.moved);
                          pass.set("offsets", buffers.offsets).set("morph_weights", buffers.weights);
                          pass.set("joints", buffers.joints).set("joint_weights", buffers.joint_weights);
                          pass.set("joint_matrices", buffers.matrices).set("flat_corners", buffers.flat);
                          pass.set("derivatives", buffers.derivatives).set("frames", buffers.moved_frames);
                          pass.set("deform", numbers).dispatch_threads({numbers.count, 1});
                      });
        copy(frame, buffers.moved, gpu_model.vertices[i]);
        if (has_frames) copy(frame, buffers.moved_frames, known->second[i]);
    }
}

}  // namespace lightwalk
