#include "04_surface_maps/tangents.h"

#include <set>

#include "04_surface_maps/exercises.h"
#include "common/base/exercise.h"
#include "common/base/progress.h"
#include "common/base/shared_lock.h"

namespace lightwalk {
namespace {

constexpr size_t reported_corners = 1 << 16;  // corners between progress reports
constexpr float nowhere_m = 1e9f;             // metres per uv without a texture direction

struct Sum {
    glm::vec3 tangent{0.0f};
    glm::vec2 metres{0.0f};
    float cos_uv = 0;
    float weight = 0;
    TangentFrame last{};
};

double angle_at(const Vertex& a, const Vertex& b, const Vertex& c) {
    const glm::dvec3 e1 = glm::dvec3(b.position - a.position), e2 = glm::dvec3(c.position - a.position);
    const double lengths = glm::length(e1) * glm::length(e2);
    return lengths > 0 ? std::acos(std::clamp(glm::dot(e1, e2) / lengths, -1.0, 1.0)) : 0.0;
}

// Angle between dP/du and dP/dv in a triangle with a non-degenerate texture area.
double cosine_of_uv(const Vertex& a, const Vertex& b, const Vertex& c) {
    const glm::dvec3 e1 = glm::dvec3(b.position - a.position), e2 = glm::dvec3(c.position - a.position);
    const glm::dvec2 uv1 = glm::dvec2(b.uv - a.uv), uv2 = glm::dvec2(c.uv - a.uv);
    const glm::dvec3 per_u = uv2.y * e1 - uv1.y * e2, per_v = uv1.x * e2 - uv2.x * e1;
    return glm::dot(per_u, per_v) / std::max(glm::length(per_u) * glm::length(per_v), 1e-300);
}

TangentFrame joined(const Sum& sum, glm::vec3 normal) {
    TangentFrame frame = sum.last;
    frame.metres_per_uv = glm::vec2(nowhere_m);
    if (!(sum.weight > 0.0f)) return frame;
    const glm::vec3 in_surface = sum.tangent - normal * glm::dot(normal, sum.tangent);
    if (!(glm::length(in_surface) > 1e-3f * sum.weight)) return frame;
    frame.tangent = glm::normalize(in_surface);
    frame.metres_per_uv = sum.metres / sum.weight;
    frame.cos_uv = sum.cos_uv / sum.weight;
    return frame;
}

// Whether the map that needs a tangent has the second texture coordinates.
bool is_of_second_uvs(const Mesh& mesh, const Material& material) {
    if (mesh.second_uvs.empty()) return false;
    for (const TextureMap* map : {&material.normal_map, &material.bump_map, &material.displacement_map})
        if (*map) return map->place.set == 1;
    return false;
}

Derivatives derivatives_of(const TangentFrame& frame, glm::vec3 normal) {
    const glm::vec3 across = frame.handedness * glm::cross(normal, frame.tangent);
    const glm::vec3 along_v =
        frame.cos_uv * frame.tangent + std::sqrt(std::max(1.0f - frame.cos_uv * frame.cos_uv, 0.0f)) * across;
    return {frame.metres_per_uv.x * frame.tangent, frame.metres_per_uv.y * along_v};
}

// How a triangle's position changes with u is linear in its corners: a target's weight scales the difference.
void add_derivatives(Mesh& mesh, const std::vector<Material>& materials) {
    Deformation& how = mesh.deformation;
    how.derivatives.clear();
    Mesh shape;
    shape.second_uvs = mesh.second_uvs;
    shape.indices = mesh.indices;
    shape.parts = mesh.parts;
    for (size_t target = 0; target <= how.targets.size(); ++target) {
        std::vector<float> weights(how.targets.size(), 0.0f);
        if (target > 0) weights[target - 1] = 1.0f;
        shape.vertices = morphed(mesh, weights);
        const std::vector<TangentFrame> frames = frame_mesh(shape, materials).frames;
        for (size_t i = 0; i < shape.vertices.size(); ++i) {
            Derivatives one = derivatives_of(frames[i], shape.vertices[i].normal);
            if (target > 0) {
                one.per_u -= how.derivatives[i].per_u;
                one.per_v -= how.derivatives[i].per_v;
            }
            how.derivatives.push_back(one);
        }
    }
}

}  // namespace

FramedMesh frame_mesh(const Mesh& mesh) { return frame_mesh(mesh, {}); }

FramedMesh frame_mesh(const Mesh& mesh, const std::vector<Material>& materials) {
    FramedMesh result{mesh.vertices, mesh.indices, {}, {}};
    std::vector<bool> second(mesh.indices.size(), false);
    for (const Part& part : mesh.parts)
        if (part.material < materials.size() && is_of_second_uvs(mesh, materials[part.material]))
            std::fill_n(second.begin() + part.first_index, part.index_count, true);
    std::vector<Sum> sums(mesh.vertices.size());
    std::map<uint32_t, uint32_t> mirrored;  // vertex → its twin of the other handedness
    const auto frame_of = tangent_frame.function();
    Progress* const waited_for = progress();
    if (waited_for) waited_for->begin("tangents", mesh.indices.size());
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        if (waited_for && i % reported_corners == 0) waited_for->step(reported_corners);
        const size_t first = i - i % 3;
        const auto corner = [&](size_t k) {
            const uint32_t index = mesh.indices[first + (i + k) % 3];
            Vertex one = mesh.vertices[index];
            if (second[i]) one.uv = mesh.second_uvs[index];
            return one;
        };
        const Vertex a = corner(0), b = corner(1), c = corner(2);
        const TangentFrame frame = frame_of(a, b, c);
        const bool directed = frame.metres_per_uv.x > 0.0f && frame.metres_per_uv.y > 0.0f;
        const float weight = directed ? static_cast<float>(angle_at(a, b, c)) : 0.0f;
        uint32_t vertex = mesh.indices[i];
        if (directed && sums[vertex].weight > 0.0f && sums[vertex].last.handedness != frame.handedness) {
            const auto [twin, added] = mirrored.emplace(vertex, static_cast<uint32_t>(sums.size()));
            if (added) {
                sums.emplace_back();
                result.vertices.push_back(Vertex(result.vertices[vertex]));
                result.copies.push_back(vertex);
            }
            vertex = result.indices[i] = twin->second;
        }
        Sum& sum = sums[vertex];
        sum.tangent += weight * frame.tangent;
        sum.metres += weight * frame.metres_per_uv;
        if (directed) sum.cos_uv += weight * static_cast<float>(cosine_of_uv(a, b, c));
        sum.weight += weight;
        if (directed || sum.weight == 0.0f) sum.last = frame;
    }
    for (size_t i = 0; i < sums.size(); ++i) result.frames.push_back(joined(sums[i], result.vertices[i].normal));
    return result;
}

std::vector<std::vector<TangentFrame>> frame_model(Model& model) {
    std::vector<std::vector<TangentFrame>> all;
    for (Mesh& mesh : model.meshes) {
        FramedMesh framed = frame_mesh(mesh, model.materials);
        all.push_back(std::move(framed.frames));
        if (framed.vertices.size() != mesh.vertices.size()) {
            mesh.add_copies(framed.copies);
            mesh.indices = std::move(framed.indices);
        }
        if (mesh.deformation && !model.motions.empty()) add_derivatives(mesh, model.materials);
    }
    return all;
}

std::string tangents_name(const Mesh& mesh) {
    return mesh.name + (Exercises::uses_solution("04.tangent_frame") ? " tangents" : " tangents by an exercise");
}

void add_tangents(Gpu& gpu, const Scene& scene) {
    std::set<GpuModel*> done;
    for (const DrawItem& item : scene.items) {
        GpuModel& gpu_model = *item.model;
        if (!done.insert(&gpu_model).second) continue;
        std::vector<Buffer>& tangents = gpu_model.attributes["tangents"];
        const std::vector<Mesh>& meshes = gpu_model.model.meshes;
        if (!tangents.empty() && tangents[0].name == tangents_name(meshes[0])) continue;
        tangents.clear();
        std::vector<size_t> vertices;
        for (const Mesh& mesh : meshes) vertices.push_back(mesh.vertices.size());
        const std::vector<std::vector<TangentFrame>> frames = unlocked([&] { return frame_model(gpu_model.model); });
        for (size_t i = 0; i < meshes.size(); ++i) {
            const Mesh& mesh = meshes[i];
            tangents.push_back(gpu.upload(tangents_name(mesh), frames[i]));
            if (mesh.vertices.size() == vertices[i]) continue;
            gpu_model.vertices[i] = gpu.upload(mesh.name + " vertices", mesh.vertices);
            gpu_model.indices[i] = gpu.upload(mesh.name + " indices", mesh.indices);
        }
        gpu_model.animated.clear();
        upload_rare_attributes(gpu, gpu_model);
    }
}

}  // namespace lightwalk
