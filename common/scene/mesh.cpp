#include "common/scene/mesh.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace lightwalk {
namespace {

bool has_no_normal(const Vertex& vertex) { return vertex.normal == glm::vec3(0.0f); }

glm::vec3 blend(glm::vec3 a, glm::vec3 b, float t) { return glm::mix(a, b, t); }
glm::quat blend(glm::quat a, glm::quat b, float t) { return glm::slerp(a, b, t); }

std::vector<float> blend(const std::vector<float>& a, const std::vector<float>& b, float t) {
    std::vector<float> result;
    for (size_t i = 0; i < a.size(); ++i) result.push_back(glm::mix(a[i], b[i], t));
    return result;
}

// Cubic Hermite spline (glTF 2.0, appendix C.5). `step_s`: duration of the segment.
template <class T>
T curve(const T& a, const T& slope_a, const T& b, const T& slope_b, float step_s, float t) {
    const float u = 1 - t;
    return (1 + 2 * t) * u * u * a + step_s * t * u * u * slope_a + (1 + 2 * u) * t * t * b -
           step_s * t * t * u * slope_b;
}
glm::quat unit(glm::quat q) { return glm::normalize(q); }
glm::vec3 unit(glm::vec3 v) { return v; }
std::vector<float> unit(std::vector<float> v) { return v; }
std::vector<float> curve(const std::vector<float>& a, const std::vector<float>& slope_a, const std::vector<float>& b,
                         const std::vector<float>& slope_b, float step_s, float t) {
    std::vector<float> result;
    for (size_t i = 0; i < a.size(); ++i) result.push_back(curve(a[i], slope_a[i], b[i], slope_b[i], step_s, t));
    return result;
}

template <class T>
T value_at(const KeyTrack<T>& track, float time_s) {
    size_t next = 0;
    while (next < track.size() && track[next].time_s <= time_s) ++next;
    if (next == 0 || next == track.size()) return track[next == 0 ? 0 : next - 1].value;
    const TimedValue<T>&a = track[next - 1], &b = track[next];
    const float step_s = b.time_s - a.time_s, t = (time_s - a.time_s) / step_s;
    if (track.between == Between::step) return a.value;
    if (track.between == Between::cubic)
        return unit(curve(a.value, track.slopes[2 * next - 1], b.value, track.slopes[2 * next], step_s, t));
    return blend(a.value, b.value, t);
}

float time_within(const Model& model, float time_s) {
    if (model.motions.empty()) return 0;
    return static_cast<float>(std::fmod(double(time_s), model.motions_s) + (time_s < 0 ? model.motions_s : 0.0f));
}

template <class T>
void copy_more(std::vector<T>& list, const std::vector<uint32_t>& copies) {
    if (list.empty()) return;
    for (const uint32_t i : copies) list.push_back(T(list[i]));
}

}  // namespace

std::vector<glm::mat4> world_transforms(const Model& model) {
    std::vector<glm::mat4> world(model.nodes.size());
    for (size_t i = 0; i < world.size(); ++i) {
        const Node& node = model.nodes[i];
        world[i] = node.parent < 0 ? node.local : world[static_cast<size_t>(node.parent)] * node.local;
    }
    return world;
}

std::vector<glm::mat4> world_transforms(const Model& model, float time_s) {
    if (model.motions.empty()) return world_transforms(model);
    const float now_s = time_within(model, time_s);
    std::vector<glm::mat4> world;
    for (const Node& node : model.nodes) world.push_back(node.local);
    for (const NodeMotion& motion : model.motions) {
        if (motion.position.empty()) continue;
        const glm::mat4 moved = glm::translate(glm::mat4(1.0f), value_at(motion.position, now_s));
        world[motion.node] =
            glm::scale(moved * glm::mat4_cast(value_at(motion.rotation, now_s)), value_at(motion.scale, now_s));
    }
    for (size_t i = 0; i < world.size(); ++i)
        if (const int parent = model.nodes[i].parent; parent >= 0)
            world[i] = world[static_cast<size_t>(parent)] * world[i];
    return world;
}

void leave_out(Model& model, const std::string& what, const std::string& unit) {
    for (LeftOut& one : model.left_out)
        if (one.what == what && one.unit == unit) {
            ++one.count;
            return;
        }
    model.left_out.push_back({what, 1, unit});
}

std::string left_out_text(const Model& model) {
    std::string text;
    for (const auto& [what, count, unit] : model.left_out) {
        text += (text.empty() ? "" : ", ") + what;
        if (!unit.empty())
            text += " (" + std::to_string(count) + " " + unit + (count == 1 ? ")" : unit.ends_with("h") ? "es)" : "s)");
    }
    return text;
}

void Mesh::add_copies(const std::vector<uint32_t>& copies) {
    copy_more(vertices, copies);
    copy_more(second_uvs, copies);
    copy_more(colors, copies);
    copy_more(deformation.rest, copies);
    copy_more(deformation.joints, copies);
    copy_more(deformation.joint_weights, copies);
    copy_more(deformation.flat, copies);
    for (MorphTarget& target : deformation.targets) {
        copy_more(target.positions, copies);
        copy_more(target.normals, copies);
    }
}

std::vector<float> morph_weights(const Model& model, const Mesh& mesh, float time_s) {
    for (const NodeMotion& motion : model.motions)
        if (motion.node == mesh.deformation.node && !motion.weights.empty()) {
            std::vector<float> weights = value_at(motion.weights, time_within(model, time_s));
            weights.resize(mesh.deformation.targets.size());
            return weights;
        }
    return mesh.deformation.weights;
}

Bounds transformed(const Bounds& box, const glm::mat4& m) {
    if (box.empty()) return box;
    const glm::vec3 middle = glm::vec3(m * glm::vec4(box.center(), 1.0f)), half = 0.5f * box.extent();
    const glm::vec3 reach =
        glm::abs(glm::vec3(m[0])) * half.x + glm::abs(glm::vec3(m[1])) * half.y + glm::abs(glm::vec3(m[2])) * half.z;
    return {middle - reach, middle + reach};
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

void flatten_missing_normals(Mesh& mesh) {
    if (std::none_of(mesh.vertices.begin(), mesh.vertices.end(), has_no_normal)) return;
    Deformation& how = mesh.deformation;
    std::vector<bool> used(mesh.vertices.size(), false);
    std::vector<uint32_t> copies;
    const size_t before = mesh.vertices.size();
    for (uint32_t& index : mesh.indices) {
        if (!has_no_normal(mesh.vertices[index])) continue;
        if (!used[index]) {
            used[index] = true;
        } else {
            copies.push_back(index);
            index = static_cast<uint32_t>(before + copies.size() - 1);
        }
    }
    mesh.add_copies(copies);
    if (!how.joints.empty() || !how.targets.empty()) {
        for (uint32_t i = 0; i < mesh.vertices.size(); ++i) how.flat.emplace_back(i);
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            for (size_t k = 0; k < 3; ++k) {
                const uint32_t vertex = mesh.indices[i + k];
                if (has_no_normal(mesh.vertices[vertex]))
                    how.flat[vertex] = {vertex, mesh.indices[i + (k + 1) % 3], mesh.indices[i + (k + 2) % 3]};
            }
    }
    fill_missing_normals(mesh);
}

void fill_missing_normals(Mesh& mesh) {
    std::vector<uint32_t> missing;
    for (uint32_t i = 0; i < mesh.vertices.size(); ++i)
        if (has_no_normal(mesh.vertices[i])) missing.push_back(i);
    if (missing.empty()) return;
    std::vector<glm::vec3> sums(mesh.vertices.size(), glm::vec3(0.0f));
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const uint32_t* corner = &mesh.indices[i];
        const glm::vec3 a = mesh.vertices[corner[0]].position;
        // The cross product's length is twice the area, which weights the normal.
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
