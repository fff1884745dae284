// CPU models as loaded: meshes, materials, node tree, animations.
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

/// Axis-aligned box; empty if lower > upper.
struct Bounds {
    glm::vec3 lower{1e30f}, upper{-1e30f};
    void add(glm::vec3 p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
    void add(const Bounds& b) { lower = glm::min(lower, b.lower), upper = glm::max(upper, b.upper); }
    bool empty() const { return lower.x > upper.x; }
    glm::vec3 center() const { return 0.5f * (lower + upper); }
    glm::vec3 extent() const { return upper - lower; }
};

/// Bounding box of a transformed box (J. Arvo, Transforming Axis-Aligned Bounding Boxes, Graphics Gems, 1990).
Bounds transformed(const Bounds& box, const glm::mat4& m);

/// Range of a mesh's indices with one material, an index into Model::materials.
struct Part {
    uint32_t first_index = 0, index_count = 0, material = 0;
};

/// Vertex offsets at weight 1; `normals` may be empty.
struct MorphTarget {
    std::vector<glm::vec3> positions, normals;
};

/// Morph targets and skin of a mesh; targets apply first.
struct Deformation {
    std::vector<Vertex> rest;  ///< undeformed; Mesh::vertices holds the pose at 0 s
    std::vector<MorphTarget> targets;
    std::vector<float> weights;
    std::vector<glm::uvec4> joints;        ///< per vertex, indices into ModelSkin::joints; empty: no skin
    std::vector<glm::vec4> joint_weights;  ///< at least 0, sum to 1 per vertex
    /// Per vertex, the corners of its triangle, itself first, where the file has no normal: it is the triangle's in every
    /// pose. Three equal corners: a normal of its own. Empty: all have normals.
    std::vector<glm::uvec3> flat;
    /// dP/du and dP/dv at rest, then their offsets by each target; empty: no tangent frames.
    std::vector<Derivatives> derivatives;
    uint32_t skin = 0;  ///< index into Model::skins; the mesh is at a node without transform
    uint32_t node = 0;  ///< node whose animation may set the weights
    explicit operator bool() const { return !rest.empty(); }
};

/// Indexed triangles, front faces counter-clockwise. All indices are below vertices.size().
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<glm::vec2> second_uvs;  ///< per vertex, or empty
    std::vector<glm::vec4> colors;      ///< linear RGBA; per vertex, or empty
    std::vector<uint32_t> indices;
    std::vector<Part> parts;
    Bounds bounds;
    Deformation deformation;

    /// Appends copies of vertices with all their attributes. `copies`: vertex indices.
    void add_copies(const std::vector<uint32_t>& copies);
};

/// Joints are node indices; `inverse_bind` maps mesh space to joint space.
struct ModelSkin {
    std::vector<uint32_t> joints;
    std::vector<glm::mat4> inverse_bind;
};

/// `parent`: index of an earlier node, or -1. `local`: transform to the parent's space.
struct Node {
    std::string name;
    int parent = -1;
    glm::mat4 local{1.0f};
    std::vector<uint32_t> meshes;
    glm::vec4 color{1.0f};  ///< times its meshes' colour and opacity
};

template <class T>
struct TimedValue {
    float time_s = 0;
    T value{};
};

enum class Between { linear, step, cubic };

/// Keyframes in ascending time, constant outside. `slopes` (cubic only): incoming and outgoing, per second.
template <class T>
struct KeyTrack : std::vector<TimedValue<T>> {
    using std::vector<TimedValue<T>>::vector;
    Between between = Between::linear;
    std::vector<T> slopes;
};

/// Animation of a node. Position, scale and rotation all have keys, replacing Node::local, or none has.
struct NodeMotion {
    uint32_t node = 0;
    KeyTrack<glm::vec3> position, scale;
    KeyTrack<glm::quat> rotation;
    KeyTrack<std::vector<float>> weights;  ///< morph target weights of the node's mesh; empty: not animated
};

/// Ignored content of a file: "KHR_materials_transmission", 2, "material".
struct LeftOut {
    std::string what;
    size_t count = 1;
    std::string unit{};
};

/// Camera of a model file, looking along its node's -z.
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
    std::vector<Material> materials;  ///< at least one: a default material if the file has none
    std::vector<Node> nodes;
    std::vector<NodeMotion> motions;
    float motions_s = 0;  ///< duration of the loop; above 0 if `motions` is not empty
    std::vector<ModelSkin> skins;
    std::vector<EncodedImage> images;  ///< PNG or JPEG files embedded in the model file
    std::vector<FileCamera> cameras;
    std::vector<FileLight> lights;
    std::vector<LeftOut> left_out;
};

void leave_out(Model& model, const std::string& what, const std::string& unit = {});

/// "KHR_materials_transmission (2 materials), skin (1)"; "" if nothing was left out.
std::string left_out_text(const Model& model);

/// Node transforms to model space.
std::vector<glm::mat4> world_transforms(const Model& model);

/// Node transforms to model space, animated.
std::vector<glm::mat4> world_transforms(const Model& model, float time_s);

/// Vertices of a mesh with its morph targets alone. `weights`: one per target.
std::vector<Vertex> morphed(const Mesh& mesh, const std::vector<float>& weights);

/// Vertices of a deformed mesh. `world`: world_transforms() at `time_s`.
std::vector<Vertex> deformed(const Model& model, const Mesh& mesh, const std::vector<glm::mat4>& world, float time_s);

/// Bounds of a mesh, and whether its front faces are clockwise, in one pose.
struct MeshPose {
    Bounds bounds;
    bool mirrored = false;
};

/// Bounds that hold a deformed mesh in any pose: a vertex is a mean of where its joints take it (glTF 2.0, 3.7.3.3), so
/// that it is within the boxes of the vertices of each joint, as the joint moves them.
class DeformedBounds {
  public:
    explicit DeformedBounds(const Mesh& mesh);
    /// `joints`: joint_matrices(), or empty.
    MeshPose at(const std::vector<float>& weights, const std::vector<glm::mat4>& joints) const;

  private:
    struct Reach {
        uint32_t joint = 0;
        float weight = 0;           ///< sum over vertices
        std::vector<Bounds> boxes;  ///< of positions at rest, then of each target's offsets
    };
    std::vector<Reach> reach_;
};

std::vector<float> morph_weights(const Model& model, const Mesh& mesh, float time_s);

/// Skinning matrices: rest pose of the mesh to model space, per joint.
std::vector<glm::mat4> joint_matrices(const Model& model, const Mesh& mesh, const std::vector<glm::mat4>& world);

/// Sets vertices to the pose at 0 s, and bounds over the whole animation, for all deformed meshes.
void deform_at_rest(Model& model);

Bounds model_bounds(const Model& model);

/// Flat normals where normals are missing; splits shared vertices, and keeps deformed ones flat in every pose.
void flatten_missing_normals(Mesh& mesh);

/// Sets zero normals to area-weighted vertex normals; (0, 1, 0) for degenerate triangles.
void fill_missing_normals(Mesh& mesh);

}  // namespace lightwalk
