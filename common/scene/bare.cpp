#include "common/scene/bare.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "common/base/error.h"
#include "common/image/decode.h"
#include "common/image/image.h"

namespace lightwalk {
namespace {

constexpr float ground_albedo = 0.5f;
constexpr float shadowed_radii = 3;  // half size of the shadow texture, in model radii
constexpr float ground_radii = 60;
constexpr float ground_gap_radii = 2e-3f;  // distance below the model, so that the model's own floor stays visible
constexpr int cells = 64;
constexpr size_t most_triangles = 2000000;  // triangles in the shadow; larger models are subsampled

float radius_of(const Bounds& bounds) {
    return bounds.empty() ? 1.0f : std::max(0.5f * glm::length(bounds.extent()), 1e-4f);
}

glm::vec3 light_from_above(const SceneFile& scene) {
    glm::vec3 sum = scene.ambient;
    for (const Light& light : scene.lights)
        sum += light.intensity * light.color * std::max(-glm::normalize(light.direction).y, 0.0f);
    return sum;
}

// Height of the lowest geometry above each ground cell, in cells; infinity: none.
class LowestAbove {
  public:
    LowestAbove(glm::vec3 middle, float reach) : middle_(middle), cell_m_(2 * reach / cells) {}

    void add(const Model& model) {
        const auto world = world_transforms(model, 0.0f);
        size_t count = 0;
        for (const Node& node : model.nodes)
            for (const uint32_t mesh : node.meshes) count += model.meshes[mesh].indices.size() / 3;
        const size_t step = 3 * std::max<size_t>(1, count / most_triangles);
        for (size_t n = 0; n < model.nodes.size(); ++n)
            for (const uint32_t number : model.nodes[n].meshes) {
                const Mesh& mesh = model.meshes[number];
                const auto corner = [&](size_t i) {
                    const glm::vec4 p(mesh.vertices[mesh.indices[i]].position, 1);
                    return (glm::vec3(world[n] * p) - middle_) / cell_m_ + glm::vec3(cells / 2, 0, cells / 2);
                };
                for (size_t i = 0; i + 2 < mesh.indices.size(); i += step) add(corner(i), corner(i + 1), corner(i + 2));
            }
    }

    // Occluded sky, cosine-weighted: a horizontal unit square at height h, distance d hides h² / (pi (d² + h²)²).
    std::vector<float> hidden() const {
        std::vector<glm::vec3> things;
        for (int z = 0; z < cells; ++z)
            for (int x = 0; x < cells; ++x)
                if (const float h = at(x, z); std::isfinite(h)) things.emplace_back(x, std::max(h, 0.6f), z);
        std::vector<float> result;
        for (int z = 0; z < cells; ++z)
            for (int x = 0; x < cells; ++x) {
                float sum = 0;
                for (const glm::vec3& t : things) {
                    const float dx = t.x - float(x), dz = t.z - float(z), h = t.y * t.y, all = dx * dx + dz * dz + h;
                    sum += h / (all * all);
                }
                result.push_back(std::min(sum / glm::pi<float>(), 1.0f));
            }
        return result;
    }

  private:
    float at(int x, int z) const { return heights_[static_cast<size_t>(z * cells + x)]; }

    void add(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        const glm::vec3 lower = glm::min(glm::min(a, b), c), upper = glm::max(glm::max(a, b), c);
        if (!(upper.x > 0 && upper.z > 0 && lower.x < cells && lower.z < cells)) return;
        const auto first = [](float v) { return std::clamp(static_cast<int>(std::floor(v)), 0, cells - 1); };
        const float area = (b.x - a.x) * (c.z - a.z) - (c.x - a.x) * (b.z - a.z);
        for (int z = first(lower.z); z <= first(upper.z); ++z)
            for (int x = first(lower.x); x <= first(upper.x); ++x) {
                const float px = float(x) + 0.5f - a.x, pz = float(z) + 0.5f - a.z;
                float height = lower.y;
                if (const bool small = upper.x - lower.x < 1 || upper.z - lower.z < 1;
                    !small && std::abs(area) > 1e-6f) {
                    const float s = (px * (c.z - a.z) - (c.x - a.x) * pz) / area;
                    const float t = ((b.x - a.x) * pz - px * (b.z - a.z)) / area;
                    if (s < -0.1f || t < -0.1f || s + t > 1.1f) continue;
                    height = std::clamp(a.y + s * (b.y - a.y) + t * (c.y - a.y), lower.y, upper.y);
                }
                float& lowest = heights_[static_cast<size_t>(z * cells + x)];
                lowest = std::min(lowest, std::max(height, 0.0f));
            }
    }

    glm::vec3 middle_;
    float cell_m_;
    std::vector<float> heights_ = std::vector<float>(static_cast<size_t>(cells * cells), INFINITY);
};

EncodedImage shadow_image(const std::vector<float>& hidden) {
    Image8 image(cells, cells);
    for (size_t i = 0; i < hidden.size(); ++i) {
        const int x = static_cast<int>(i) % cells, z = static_cast<int>(i) / cells;
        const bool edge = x == 0 || z == 0 || x == cells - 1 || z == cells - 1;
        const float code = linear_to_srgb(edge ? 1.0f : 1.0f - 0.8f * hidden[i]);
        image.pixels[i] = glm::u8vec4(glm::u8vec3(static_cast<uint8_t>(std::lround(255 * code))), 255);
    }
    const std::string bytes = encode_png(image);
    const auto* begin = reinterpret_cast<const std::byte*>(bytes.data());
    return std::make_shared<const std::vector<std::byte>>(begin, begin + bytes.size());
}

// Textured square, surrounded by a larger one with the texture's edge colour.
Mesh ground_mesh(glm::vec3 middle, float radius) {
    Mesh mesh;
    mesh.name = "ground";
    for (const float half : {shadowed_radii * radius, ground_radii * radius})
        for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
            const glm::vec3 position = middle + glm::vec3(half * corner.x, 0, half * corner.y);
            mesh.vertices.push_back({position, {0, 1, 0}, {0.5f + 0.5f * corner.x, 0.5f - 0.5f * corner.y}});
            mesh.bounds.add(position);
        }
    mesh.indices = {0, 2, 1, 0, 3, 2};
    for (uint32_t i = 0; i < 4; ++i) {
        const uint32_t j = (i + 1) % 4;
        mesh.indices.insert(mesh.indices.end(), {i, j, 4 + j, i, 4 + j, 4 + i});
    }
    mesh.parts = {{0, static_cast<uint32_t>(mesh.indices.size()), 0}};
    return mesh;
}

bool is_lit(const Model& model) {
    for (const Mesh& mesh : model.meshes)
        for (const Part& part : mesh.parts)
            if (!model.materials[part.material].unlit) return true;
    return false;
}

}  // namespace

SceneFile scene_of_model(const std::filesystem::path& model, const Bounds& bounds) {
    SceneFile scene;
    scene.file = model;
    scene.bare = true;
    scene.objects.push_back({.name = model.stem().string(), .parent = {}, .model = model, .material = {}});
    scene.objects[0].material.two_sided = true;
    const glm::vec3 center = bounds.empty() ? glm::vec3(0.0f) : bounds.center();
    const float radius = radius_of(bounds);
    Camera& camera = scene.camera;
    camera.fov_y_rad = glm::radians(35.0f);
    camera.target = center;
    camera.position =
        center + glm::normalize(glm::vec3(0.55f, 0.3f, 1.0f)) * radius / std::sin(0.5f * camera.fov_y_rad);
    camera.near_m = radius * 0.02f;
    camera.far_m = radius * 100.0f;
    scene.lights = {{.color = {1.0f, 0.97f, 0.92f}, .direction = glm::normalize(glm::vec3(0.25f, -0.7f, -0.66f))},
                    {.color = {0.75f, 0.87f, 1.0f}, .direction = glm::normalize(glm::vec3(-0.97f, -0.2f, 0.0f))}};
    scene.lights[0].intensity = 0.66f;
    scene.lights[0].shadow = true;
    scene.lights[1].intensity = 0.14f;
    scene.ambient = {0.2f, 0.21f, 0.23f};
    scene.background = ground_albedo * light_from_above(scene);
    return scene;
}

void add_ground(SceneFile& scene, const Model& model) {
    if (!is_lit(model)) return;
    const SceneObject& above = scene.objects.at(0);
    scene.objects.push_back({.name = above.name == "ground" ? "ground below" : "ground",
                             .parent = {},
                             .model = above.model,
                             .material = {},
                             .ground = true});
}

Model ground_below(const Model& model, const std::string& name) {
    const auto world = world_transforms(model, 0.0f);
    Bounds bounds;
    for (size_t n = 0; n < model.nodes.size(); ++n)
        for (const uint32_t number : model.nodes[n].meshes) {
            const Mesh& mesh = model.meshes[number];
            Bounds first = mesh.bounds;
            if (mesh.deformation) {  // the model stands in its pose at 0 s; its bounds hold the whole animation
                first = {};
                for (const Vertex& v : mesh.vertices) first.add(v.position);
            }
            bounds.add(transformed(first, world[n]));
        }
    if (bounds.empty()) bounds.add(glm::vec3(0));
    const float radius = radius_of(bounds);
    const glm::vec3 middle(bounds.center().x, bounds.lower.y - ground_gap_radii * radius, bounds.center().z);
    LowestAbove lowest(middle, shadowed_radii * radius);
    lowest.add(model);
    Model ground;
    Mesh mesh = ground_mesh(middle, radius);
    for (size_t i = 4; i < 8; ++i) mesh.vertices[i].uv = mesh.vertices[i - 4].uv;
    Material& material = ground.materials.emplace_back();
    material.name = "ground";
    material.diffuse = glm::vec3(ground_albedo);
    material.diffuse_map.file = name + ", shadow";
    material.diffuse_map.bytes = shadow_image(lowest.hidden());
    material.diffuse_map.sampler.wrap = Wrap::clamp;
    ground.meshes.push_back(std::move(mesh));
    ground.nodes.push_back({"ground", -1, glm::mat4(1), {0}});
    return ground;
}

std::string why_invisible(const Model& model, glm::vec3 eye) {
    const auto world = world_transforms(model, 0.0f);
    bool any_opaque = false, any_area = false;
    size_t looked_at = 0;
    for (size_t n = 0; n < model.nodes.size(); ++n)
        for (const uint32_t number : model.nodes[n].meshes) {
            const Mesh& mesh = model.meshes[number];
            const bool is_mirrored =
                mesh.deformation &&
                DeformedBounds(mesh).at(morph_weights(model, mesh, 0.0f), joint_matrices(model, mesh, world)).mirrored;
            for (const Part& part : mesh.parts) {
                const Material& material = model.materials[part.material];
                const bool is_cut = material.alpha_cutoff >= 0.0f && !material.blend;
                if (is_cut ? material.opacity < material.alpha_cutoff
                           : material.opacity <= 0.0f && material.transmission.r < 0.0f)
                    continue;
                any_opaque = true;
                const float turned = (glm::determinant(glm::mat3(world[n])) < 0) != is_mirrored ? -1.0f : 1.0f;
                for (size_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3) {
                    if (++looked_at > most_triangles) return "";
                    const auto at = [&](size_t k) {
                        return glm::vec3(world[n] * glm::vec4(mesh.vertices[mesh.indices[i + k]].position, 1));
                    };
                    const glm::vec3 a = at(0), normal = glm::cross(at(1) - a, at(2) - a);
                    if (normal == glm::vec3(0)) continue;
                    any_area = true;
                    if (material.sides != Sides::front || turned * glm::dot(normal, eye - a) > 0) return "";
                }
            }
        }
    return !any_opaque ? "all of its materials are transparent (opacity 0)"
           : !any_area ? "none of its triangles has an area"
                       : "all of its triangles face away, and the file says that they have no back";
}

Camera placed(const FileCamera& from, const glm::mat4& place, float distance_m) {
    Camera camera = from.camera;
    camera.position = glm::vec3(place[3]);
    camera.target = camera.position - std::max(distance_m, 1e-3f) * glm::normalize(glm::vec3(place[2]));
    camera.up = glm::normalize(glm::vec3(place[1]));
    return camera;
}

// KHR_lights_punctual: node scale affects neither intensity nor range.
Light placed(const FileLight& from, const glm::mat4& place) {
    Light light = from.light;
    light.position = glm::vec3(place[3]);
    light.direction = -glm::normalize(glm::vec3(place[2]));
    light.shadow = true;
    return light;
}

void use_camera_of_file(SceneFile& scene, const Model& model, size_t number) {
    const std::string file = scene.file.string();
    if (model.cameras.empty()) throw InputError("{}: --camera-of-file: the file has no camera", file);
    if (number < 1 || number > model.cameras.size())
        throw InputError("{}: --camera-of-file {}: the file has {} camera{}", file, number, model.cameras.size(),
                         model.cameras.size() == 1 ? "" : "s");
    const auto world = world_transforms(model, 0.0f);
    const FileCamera& from = model.cameras[number - 1];
    const glm::mat4& place = world[from.node];
    scene.camera = placed(from, place, glm::length(scene.camera.target - glm::vec3(place[3])));
    if (model.lights.empty()) return;
    scene.lights.clear();
    for (const FileLight& light : model.lights) scene.lights.push_back(placed(light, world[light.node]));
}

}  // namespace lightwalk
