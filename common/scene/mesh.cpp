#include "common/scene/mesh.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace lightwalk {
namespace {

glm::vec3 blend(glm::vec3 a, glm::vec3 b, float t) { return glm::mix(a, b, t); }
glm::quat blend(glm::quat a, glm::quat b, float t) { return glm::slerp(a, b, t); }

template <class T>
T value_at(const std::vector<TimedValue<T>>& values, float time_s) {
    size_t next = 0;
    while (next < values.size() && values[next].time_s <= time_s) ++next;
    if (next == 0 || next == values.size()) return values[next == 0 ? 0 : next - 1].value;
    const TimedValue<T>&a = values[next - 1], &b = values[next];
    return blend(a.value, b.value, (time_s - a.time_s) / (b.time_s - a.time_s));
}

}  // namespace

// [world_transforms]
std::vector<glm::mat4> world_transforms(const Model& model) {
    std::vector<glm::mat4> world(model.nodes.size());
    for (size_t i = 0; i < world.size(); ++i) {
        const Node& node = model.nodes[i];
        world[i] = node.parent < 0 ? node.local : world[static_cast<size_t>(node.parent)] * node.local;
    }
    return world;
}
// [/world_transforms]

std::vector<glm::mat4> world_transforms(const Model& model, float time_s) {
    if (model.motions.empty()) return world_transforms(model);
    const double time = std::fmod(double(time_s), model.motions_s) + (time_s < 0 ? model.motions_s : 0.0f);
    std::vector<glm::mat4> world;
    for (const Node& node : model.nodes) world.push_back(node.local);
    for (const NodeMotion& motion : model.motions) {
        const auto now_s = static_cast<float>(time);
        const glm::mat4 moved = glm::translate(glm::mat4(1.0f), value_at(motion.position, now_s));
        world[motion.node] =
            glm::scale(moved * glm::mat4_cast(value_at(motion.rotation, now_s)), value_at(motion.scale, now_s));
    }
    for (size_t i = 0; i < world.size(); ++i)
        if (const int parent = model.nodes[i].parent; parent >= 0)
            world[i] = world[static_cast<size_t>(parent)] * world[i];
    return world;
}

Bounds model_bounds(const Model& model) {
    const auto world = world_transforms(model);
    Bounds bounds;
    for (size_t i = 0; i < model.nodes.size(); ++i)
        for (const uint32_t mesh : model.nodes[i].meshes)
            for (const Vertex& v : model.meshes[mesh].vertices)
                bounds.add(glm::vec3(world[i] * glm::vec4(v.position, 1.0f)));
    return bounds;
}

void fill_missing_normals(Mesh& mesh) {
    std::vector<uint32_t> missing;
    for (uint32_t i = 0; i < mesh.vertices.size(); ++i)
        if (mesh.vertices[i].normal == glm::vec3(0.0f)) missing.push_back(i);
    if (missing.empty()) return;
    std::vector<glm::vec3> sums(mesh.vertices.size(), glm::vec3(0.0f));
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const uint32_t* corner = &mesh.indices[i];
        const glm::vec3 a = mesh.vertices[corner[0]].position;
        // The cross product's length is twice the area, which is the weight.
        const glm::vec3 weighted =
            glm::cross(mesh.vertices[corner[1]].position - a, mesh.vertices[corner[2]].position - a);
        for (int k = 0; k < 3; ++k) sums[corner[k]] += weighted;
    }
    for (const uint32_t i : missing) {
        const float length = glm::length(sums[i]);
        mesh.vertices[i].normal =
            length > 0.0f && std::isfinite(length) ? sums[i] / length : glm::vec3(0.0f, 1.0f, 0.0f);
    }
}

}  // namespace lightwalk
