// What a loader delivers: meshes, materials and a node tree, on the CPU.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

#include "common/scene/material.h"
#include "common/structs.h"

namespace lightwalk {

/// Axis-aligned box, in the space that its owner states; empty when lower > upper.
struct Bounds {
    glm::vec3 lower{1e30f}, upper{-1e30f};
    void add(glm::vec3 p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
    void add(const Bounds& b) { lower = glm::min(lower, b.lower), upper = glm::max(upper, b.upper); }
    bool empty() const { return lower.x > upper.x; }
    glm::vec3 center() const { return 0.5f * (lower + upper); }
    glm::vec3 extent() const { return upper - lower; }
};

/// A run of a mesh's indices drawn with one material. `material` indexes Model::materials.
struct Part {
    uint32_t first_index = 0, index_count = 0, material = 0;
};

/// Triangles with shared vertices; counter-clockwise is the front. Every index is below vertices.size().
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;
    std::vector<Part> parts;
    Bounds bounds;
};

/// A node of the tree: `parent` is an earlier node or -1; `local` maps to the parent's space.
struct Node {
    std::string name;
    int parent = -1;
    glm::mat4 local{1.0f};
    std::vector<uint32_t> meshes;
};

template <class T>
struct TimedValue {
    float time_s = 0;
    T value{};
};

/// A node that a model file moves: values in rising time, linear in between, those of the ends outside. None is empty.
/// They take the place of Node::local: scaled, then rotated, then moved.
struct NodeMotion {
    uint32_t node = 0;
    std::vector<TimedValue<glm::vec3>> position, scale;
    std::vector<TimedValue<glm::quat>> rotation;
};

struct Model {
    std::vector<Mesh> meshes;
    std::vector<Material> materials;  ///< never empty: a default stands in where the file names none
    std::vector<Node> nodes;
    std::vector<NodeMotion> motions;
    float motions_s = 0;  ///< how long they take; then they begin anew. Above 0 where there is one
};

/// Each node's transform into the model's space: the product of the locals from the root down.
std::vector<glm::mat4> world_transforms(const Model& model);

/// The same at a time, with the nodes moved by the model's motions.
std::vector<glm::mat4> world_transforms(const Model& model, float time_s);

/// The box around every vertex that a node places.
Bounds model_bounds(const Model& model);

/// Area-weighted vertex normals for the vertices that have none (zero); leaves others alone. Degenerate: (0, 1, 0).
void fill_missing_normals(Mesh& mesh);

}  // namespace lightwalk
