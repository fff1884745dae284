// The loaders' result: meshes, materials and a node tree, on the CPU.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

#include "common/scene/camera.h"
#include "common/scene/light.h"
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

/// The box around a box that was turned (J. Arvo, Transforming Axis-Aligned Bounding Boxes, Graphics Gems, 1990).
Bounds transformed(const Bounds& box, const glm::mat4& m);

/// A run of a mesh's indices drawn with one material. `material` indexes Model::materials.
struct Part {
    uint32_t first_index = 0, index_count = 0, material = 0;
};

/// Offsets of a mesh's vertices at weight 1. `normals` may be empty.
struct MorphTarget {
    std::vector<glm::vec3> positions, normals;
};

/// Deformations of a mesh: morph targets, then the joints of a skin.
struct Deformation {
    std::vector<Vertex> rest;  ///< before either; Mesh::vertices is as at 0 s
    std::vector<MorphTarget> targets;
    std::vector<float> weights;            ///< of the targets, where no motion says otherwise
    std::vector<glm::uvec4> joints;        ///< of ModelSkin::joints, for each vertex; empty: no skin
    std::vector<glm::vec4> joint_weights;  ///< they sum to 1
    uint32_t skin = 0;                     ///< of Model::skins; the mesh is then at a node that has no transform
    uint32_t node = 0;                     ///< its animation may move the weights
    explicit operator bool() const { return !rest.empty(); }
};

/// Triangles with shared vertices; counter-clockwise is the front. Every index is below vertices.size().
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<glm::vec2> second_uvs;  ///< one for each vertex, or none
    std::vector<glm::vec4> colors;      ///< linear, and alpha; one for each vertex, or none
    std::vector<uint32_t> indices;
    std::vector<Part> parts;
    Bounds bounds;
    Deformation deformation;

    /// Adds copies of vertices, with all that belongs to a vertex; `copies` are earlier vertices.
    void add_copies(const std::vector<uint32_t>& copies);
};

/// Joints are nodes; `inverse_bind` maps from the mesh's space into each joint's.
struct ModelSkin {
    std::vector<uint32_t> joints;
    std::vector<glm::mat4> inverse_bind;
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

enum class Between { linear, step, cubic };

/// Values in rising time; constant outside. `slopes` of cubic ones: before and after each value, per second.
template <class T>
struct KeyTrack : std::vector<TimedValue<T>> {
    using std::vector<TimedValue<T>>::vector;
    Between between = Between::linear;
    std::vector<T> slopes;
};

/// A node that a model file moves. `position`, `scale` and `rotation` are not empty, unless all three are; they take the
/// place of Node::local: scaled, then rotated, then moved.
struct NodeMotion {
    uint32_t node = 0;
    KeyTrack<glm::vec3> position, scale;
    KeyTrack<glm::quat> rotation;
    KeyTrack<std::vector<float>> weights;  ///< of the morph targets of the node's mesh; empty: they stay
};

/// Content of a file that is not drawn: "KHR_materials_transmission", 2, "material".
struct LeftOut {
    std::string what;
    size_t count = 1;
    std::string unit{};  ///< the counted thing, in the singular; empty: it occurs once
};

/// A camera or a light of a model file, at a node and looking along the node's -z.
struct FileCamera {
    uint32_t node = 0;
    Camera camera;
    std::string name{};
};
struct FileLight {
    uint32_t node = 0;
    Light light;
};

using EncodedImage = std::shared_ptr<const std::vector<std::byte>>;

struct Model {
    std::vector<Mesh> meshes;
    std::vector<Material> materials;  ///< never empty: a default stands in where the file names none
    std::vector<Node> nodes;
    std::vector<NodeMotion> motions;
    float motions_s = 0;  ///< duration, after which they repeat; above 0 if there is one
    std::vector<ModelSkin> skins;
    std::vector<EncodedImage> images;  ///< PNG or JPEG files inside of the model's
    std::vector<FileCamera> cameras;
    std::vector<FileLight> lights;
    std::vector<LeftOut> left_out;
};

/// Counts one more `what`.
void leave_out(Model& model, const std::string& what, const std::string& unit = {});

/// "KHR_materials_transmission (2 materials), skin (1)"; "" where nothing was.
std::string left_out_text(const Model& model);

/// Each node's transform into the model's space: the product of the locals from the root down.
std::vector<glm::mat4> world_transforms(const Model& model);

/// The same at a time, with the nodes moved by the model's motions.
std::vector<glm::mat4> world_transforms(const Model& model, float time_s);

/// A deformed mesh's vertices at a time. `world`: all nodes' transforms then.
std::vector<Vertex> deformed(const Model& model, const Mesh& mesh, const std::vector<glm::mat4>& world, float time_s);

/// The weights of a mesh's morph targets at a time.
std::vector<float> morph_weights(const Model& model, const Mesh& mesh, float time_s);

/// For each joint of a mesh's skin, from the mesh at rest into the model's space.
std::vector<glm::mat4> joint_matrices(const Model& model, const Mesh& mesh, const std::vector<glm::mat4>& world);

/// Deforms the meshes that can be as at 0 s, and sets their bounds.
void deform_at_rest(Model& model);

/// The box around every vertex that a node places.
Bounds model_bounds(const Model& model);

/// Flat normals: every triangle has vertices of its own where a normal is missing.
void flatten_missing_normals(Mesh& mesh);

/// Area-weighted vertex normals for the vertices that have none (zero); leaves others alone. Degenerate: (0, 1, 0).
void fill_missing_normals(Mesh& mesh);

}  // namespace lightwalk
