#include "common/scene/mesh.h"

namespace lightwalk {

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
    for (const Vertex& v : mesh.vertices)
        if (v.normal != glm::vec3(0.0f)) return;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Vertex& a = mesh.vertices[mesh.indices[i]];
        Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        // The cross product's length is twice the area, which is the weight.
        const glm::vec3 weighted = glm::cross(b.position - a.position, c.position - a.position);
        a.normal += weighted, b.normal += weighted, c.normal += weighted;
    }
    for (Vertex& v : mesh.vertices) {
        const float length = glm::length(v.normal);
        v.normal = length > 0.0f ? v.normal / length : glm::vec3(0.0f, 1.0f, 0.0f);
    }
}

}  // namespace lightwalk
