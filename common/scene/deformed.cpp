// Mesh deformation on the processor: morph targets first, then the joints of a skin (glTF 2.0, 3.7.2.2 and 3.7.3).
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "common/scene/mesh.h"

namespace lightwalk {
namespace {

constexpr int sampled_times = 8;
constexpr size_t most_times = 64;

glm::vec3 normal_or(glm::vec3 v, glm::vec3 other) {
    const float length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : other;
}

float side(const glm::mat3& m) { return glm::determinant(m) < 0.0f ? -1.0f : 1.0f; }

// Matrix of normals: the inverse transpose, times a positive number, so that a flat joint has one, too.
glm::mat3 normal_matrix(const glm::mat3& m) {
    return side(m) * glm::mat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
}

// Normals of triangles, for vertices that have none of their own. `turned`: 1, or -1 where a joint mirrors.
template <class Turned>
void set_flat_normals(const Mesh& mesh, std::vector<Vertex>& vertices, const Turned& turned) {
    const std::vector<glm::uvec3>& flat = mesh.deformation.flat;
    for (size_t i = 0; i < flat.size(); ++i) {
        if (flat[i].x == flat[i].y) continue;
        const glm::vec3 a = vertices[flat[i].x].position;
        const glm::vec3 across = glm::cross(vertices[flat[i].y].position - a, vertices[flat[i].z].position - a);
        vertices[i].normal = normal_or(turned(i) * across, vertices[i].normal);
    }
}

glm::mat4 joint_of(const Deformation& how, const std::vector<glm::mat4>& joints, size_t vertex) {
    glm::mat4 sum(0.0f);
    for (int k = 0; k < 4; ++k) sum += how.joint_weights[vertex][k] * joints[how.joints[vertex][k]];
    return sum;
}

template <class T>
void add_times(const KeyTrack<T>& track, std::set<float>& times) {
    for (const TimedValue<T>& key : track) times.insert(key.time_s);
}

// Times at which the bounds of a whole clip are taken: its keys, and even steps between them.
std::vector<float> times_of(const Model& model) {
    std::set<float> times;
    for (int i = 1; i < sampled_times; ++i) times.insert(model.motions_s * static_cast<float>(i) / sampled_times);
    for (const NodeMotion& motion : model.motions) {
        add_times(motion.position, times);
        add_times(motion.scale, times);
        add_times(motion.rotation, times);
        add_times(motion.weights, times);
    }
    std::vector<float> some;
    const size_t step = (times.size() + most_times - 1) / most_times;
    size_t i = 0;
    for (const float time_s : times)
        // The end of a clip is its beginning; just before it is not.
        if (i++ % step == 0) some.push_back(std::min(time_s, std::nextafter(model.motions_s, 0.0f)));
    return some;
}

}  // namespace

std::vector<glm::mat4> joint_matrices(const Model& model, const Mesh& mesh, const std::vector<glm::mat4>& world) {
    if (mesh.deformation.joints.empty()) return {};
    const ModelSkin& skin = model.skins[mesh.deformation.skin];
    std::vector<glm::mat4> matrices;
    for (size_t i = 0; i < skin.joints.size(); ++i) matrices.push_back(world[skin.joints[i]] * skin.inverse_bind[i]);
    return matrices;
}

std::vector<Vertex> morphed(const Mesh& mesh, const std::vector<float>& weights) {
    const Deformation& how = mesh.deformation;
    std::vector<Vertex> vertices = how.rest;
    for (size_t i = 0; i < vertices.size(); ++i) {
        Vertex& v = vertices[i];
        const glm::vec3 given = v.normal;
        for (size_t t = 0; t < how.targets.size(); ++t) {
            v.position += weights[t] * how.targets[t].positions[i];
            if (!how.targets[t].normals.empty()) v.normal += weights[t] * how.targets[t].normals[i];
        }
        v.normal = normal_or(v.normal, given);
    }
    set_flat_normals(mesh, vertices, [](size_t) { return 1.0f; });
    return vertices;
}

std::vector<Vertex> deformed(const Model& model, const Mesh& mesh, const std::vector<glm::mat4>& world, float time_s) {
    const Deformation& how = mesh.deformation;
    std::vector<Vertex> vertices = morphed(mesh, morph_weights(model, mesh, time_s));
    if (how.joints.empty()) return vertices;
    const std::vector<glm::mat4> joints = joint_matrices(model, mesh, world);
    for (size_t i = 0; i < vertices.size(); ++i) {
        Vertex& v = vertices[i];
        const glm::mat4 joint = joint_of(how, joints, i);
        v.position = glm::vec3(joint * glm::vec4(v.position, 1.0f));
        v.normal = normal_or(normal_matrix(glm::mat3(joint)) * v.normal, v.normal);
    }
    set_flat_normals(mesh, vertices, [&](size_t i) { return side(glm::mat3(joint_of(how, joints, i))); });
    return vertices;
}

DeformedBounds::DeformedBounds(const Mesh& mesh) {
    const Deformation& how = mesh.deformation;
    std::map<uint32_t, Reach> reach;
    for (size_t i = 0; i < how.rest.size(); ++i)
        for (int k = 0; k < (how.joints.empty() ? 1 : 4); ++k) {
            const float weight = how.joints.empty() ? 1.0f : how.joint_weights[i][k];
            if (!(weight > 0)) continue;
            const uint32_t joint = how.joints.empty() ? 0 : how.joints[i][k];
            Reach& one = reach[joint];
            one.joint = joint;
            one.weight += weight;
            one.boxes.resize(1 + how.targets.size());
            one.boxes[0].add(how.rest[i].position);
            for (size_t t = 0; t < how.targets.size(); ++t) one.boxes[1 + t].add(how.targets[t].positions[i]);
        }
    for (auto& [joint, one] : reach) reach_.push_back(std::move(one));
}

MeshPose DeformedBounds::at(const std::vector<float>& weights, const std::vector<glm::mat4>& joints) const {
    MeshPose pose;
    float turned = 0;
    for (const Reach& one : reach_) {
        Bounds box = one.boxes[0];
        for (size_t t = 0; t < weights.size(); ++t) {
            const glm::vec3 a = weights[t] * one.boxes[1 + t].lower, b = weights[t] * one.boxes[1 + t].upper;
            box.lower += glm::min(a, b);
            box.upper += glm::max(a, b);
        }
        pose.bounds.add(joints.empty() ? box : transformed(box, joints[one.joint]));
        if (!joints.empty()) turned += one.weight * side(glm::mat3(joints[one.joint]));
    }
    pose.mirrored = turned < 0;
    return pose;
}

void deform_at_rest(Model& model) {
    const auto world = world_transforms(model, 0.0f);
    const std::vector<float> times = model.motions.empty() ? std::vector<float>() : times_of(model);
    for (Mesh& mesh : model.meshes) {
        if (!mesh.deformation) continue;
        mesh.vertices = deformed(model, mesh, world, 0.0f);
        mesh.bounds = {};
        for (const Vertex& v : mesh.vertices) mesh.bounds.add(v.position);
        for (const float time_s : times)
            for (const Vertex& v : deformed(model, mesh, world_transforms(model, time_s), time_s))
                mesh.bounds.add(v.position);
    }
}

}  // namespace lightwalk
