#include "04_surface_maps/need.h"

#include <algorithm>
#include <optional>

#include "02_lambert_phong/truth.h"
#include "04_surface_maps/height_field.h"
#include "04_surface_maps/maps.h"
#include "04_surface_maps/truth.h"
#include "common/base/add_line.h"
#include "common/image/image.h"

namespace lightwalk {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr glm::ivec2 rays(64, 36);
constexpr double lowest_eye = 0.02;  // as in parallax.glsl
constexpr double other_reads = 8;    // what a pixel costs beside the search: colour, normal and lights, about

// From the mean over rays to FLIP's mean, over the scenes of the study and lava.json: where most pixels are a little
// wrong the two are proportional; where few are very wrong, as where a thin bump was missed, FLIP's filters spread
// them, and it grows as a power. Each number is the largest that was found, rounded up.
double to_flip(const std::string& method, double mean) {
    if (method == "relief") return 1.15 * std::pow(mean, 0.75);
    if (method == "occlusion") return 0.85 * std::pow(mean, 0.75);
    return 1.4 * mean;
}

// What FLIP would say of a large area of one linear colour in the place of another, about: one 8-bit step of grey is
// 0.03 (docs/study_format.md), and more goes by the power that FLIP's colour term has (its qc). The channel that
// differs most counts: red for yellow is as visible as black for grey.
double visible(dvec3 a, dvec3 b) {
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        const auto code = [](double linear) {
            return 255.0 * double(linear_to_srgb(static_cast<float>(std::clamp(linear, 0.0, 1.0))));
        };
        most = std::max(most, std::fabs(code(a[i]) - code(b[i])));
    }
    return std::min(1.0, 0.03 * std::pow(most, 0.7));
}

// A texture on the CPU, read as the device does but for the weights between levels.
class Texture {
  public:
    Texture() = default;
    explicit Texture(std::vector<Level> levels) : levels_(std::move(levels)) {}
    bool empty() const { return levels_.empty(); }

    /// `at` and `uv_per_pixel` with the whole texture as 1, rows from the top.
    glm::dvec4 read(dvec2 at, double uv_per_pixel) const {
        const double wanted = std::log2(std::max(uv_per_pixel * std::max(levels_[0].size.x, levels_[0].size.y), 1.0));
        const Level& level = levels_[std::min(static_cast<size_t>(std::lround(wanted)), levels_.size() - 1)];
        const dvec2 place = at * dvec2(level.size) - 0.5, inside = glm::fract(place);
        const glm::ivec2 size(level.size), cell(glm::floor(place));
        const auto texel = [&](glm::ivec2 off) {
            const glm::ivec2 in = ((cell + off) % size + size) % size;
            return glm::dvec4(level.texels[size_t(in.y) * level.size.x + size_t(in.x)]);
        };
        return glm::mix(glm::mix(texel({0, 0}), texel({1, 0}), inside.x),
                        glm::mix(texel({0, 1}), texel({1, 1}), inside.x), inside.y);
    }

  private:
    std::vector<Level> levels_;
};

struct Maps {
    HeightField field;
    Texture color, normal, glow;
};

Maps read_maps(Gpu& gpu, const DrawItem& item) {
    Maps maps;
    maps.field = HeightField({1, 1}, {1.0f});  // flat, where there is no map
    if (const auto& height = item.maps[MapSlot::height]) {
        const Level level = read_level(gpu, *height);
        std::vector<float> heights;
        for (const glm::vec4& texel : level.texels) heights.push_back(texel.r);
        maps.field = HeightField(glm::ivec2(level.size), std::move(heights));
    }
    const auto texture = [&](MapSlot slot, bool is_normal) {
        const auto& map = item.maps[slot];
        if (!map) return Texture();
        const Level level = read_level(gpu, *map);
        return Texture(is_normal ? normal_levels(level) : cutout_levels(level, -1.0f));
    };
    maps.color = texture(MapSlot::diffuse, false);
    maps.glow = texture(MapSlot::emissive, false);
    maps.normal = texture(MapSlot::normal, true);
    return maps;
}

struct RayHit {
    const DrawItem* item = nullptr;
    double distance_m = 1e30;
    dvec3 per_u{0}, per_v{0}, normal{0};  // metres for each u and v; world space
    dvec2 uv{0};
};

// The nearest front face along the ray (T. Möller and B. Trumbore, 1997).
RayHit nearest(const Scene& scene, dvec3 eye, dvec3 direction) {
    RayHit hit;
    for (const DrawItem& item : scene.items) {
        const Mesh& mesh = item.model->model.meshes[item.mesh];
        const Part& part = mesh.parts[item.part];
        const glm::dmat4 to_object = glm::inverse(glm::dmat4(item.transform));
        const dvec3 from(to_object * glm::dvec4(eye, 1)), along(to_object * glm::dvec4(direction, 0));
        for (uint32_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3) {
            const Vertex *a = &mesh.vertices[mesh.indices[i]], *b = &mesh.vertices[mesh.indices[i + 1]],
                         *c = &mesh.vertices[mesh.indices[i + 2]];
            const dvec3 e1(b->position - a->position), e2(c->position - a->position), p = glm::cross(along, e2);
            const double det = glm::dot(e1, p);
            if (!(det > 1e-14)) continue;
            const dvec3 s = from - dvec3(a->position), q = glm::cross(s, e1);
            const double x = glm::dot(s, p) / det, y = glm::dot(along, q) / det, t = glm::dot(e2, q) / det;
            if (x < 0 || y < 0 || x + y > 1 || t <= 0 || t >= hit.distance_m) continue;
            const dvec2 uv1(b->uv - a->uv), uv2(c->uv - a->uv);
            const double uv_det = uv1.x * uv2.y - uv2.x * uv1.y;
            if (uv_det == 0) continue;
            const glm::dmat3 to_world(item.transform);
            hit = {&item,
                   t,
                   to_world * ((uv2.y * e1 - uv1.y * e2) / uv_det),
                   to_world * ((uv1.x * e2 - uv2.x * e1) / uv_det),
                   glm::normalize(glm::cross(to_world * e1, to_world * e2)) * (item.mirrored ? -1.0 : 1.0),
                   dvec2(a->uv) + x * uv1 + y * uv2};
        }
    }
    return hit;
}

// One ray on a surface with a height map: where each method sees it, and how that looks.
struct Probe {
    const Scene& scene;
    const Maps& maps;
    const RayHit& hit;
    dvec2 start, along;  // texels; along is the way to depth 1
    double cosine, uv_per_pixel;

    dvec3 shade(const std::string& method, dvec2 texel) const {
        const dvec2 at = (texel + 0.5) / dvec2(maps.field.size());
        dvec3 color(hit.item->material.diffuse), glow(hit.item->material.emissive), normal(0, 0, 1);
        if (!maps.color.empty()) color *= dvec3(maps.color.read(at, uv_per_pixel));
        if (!maps.glow.empty()) glow *= dvec3(maps.glow.read(at, uv_per_pixel));
        if (!maps.normal.empty() && method != "flat")
            normal = truth::unpack_normal(dvec2(maps.normal.read(at, uv_per_pixel)), 1);
        const dvec3 world = glm::normalize(normal.x * glm::normalize(hit.per_u) + normal.y * glm::normalize(hit.per_v) +
                                           normal.z * hit.normal);
        dvec3 light(scene.file.ambient);
        for (const Light& l : scene.file.lights)
            if (l.kind == Light::Kind::directional && glm::dot(hit.normal, dvec3(l.direction)) < 0)
                light += dvec3(l.color * l.intensity) * truth::lambert(world, -dvec3(l.direction));
        return color * light + glow;
    }
};

std::optional<Probe> probe_at(const Scene& scene, const Maps& maps, const RayHit& hit, dvec3 to_eye, double height_m,
                              double pixel_m) {
    const dvec2 metres(glm::length(hit.per_u), glm::length(hit.per_v)), size(maps.field.size());
    const double cosine = std::max(glm::dot(to_eye, hit.normal), lowest_eye);
    const dvec2 sideways(glm::dot(to_eye, hit.per_u) / metres.x, glm::dot(to_eye, hit.per_v) / metres.y);
    if (!(metres.x > 0 && metres.y > 0)) return {};
    const dvec2 shift = height_m / metres * sideways / cosine;
    // Rows of the image grow against v.
    return Probe{scene,
                 maps,
                 hit,
                 dvec2(hit.uv.x, 1 - hit.uv.y) * size - 0.5,
                 dvec2(-shift.x, shift.y) * size,
                 cosine,
                 pixel_m / cosine / std::min(metres.x, metres.y)};
}

double reads(const std::string& method, int steps, double depth, dvec2 along) {
    if (method == "flat") return 0;
    if (method == "normal") return 1;
    if (method == "offset" || method == "offset_limited") return 2;
    if (method == "exact") return 1 + 4 * (1 + depth * (std::fabs(along.x) + std::fabs(along.y)));
    return 2 + depth * steps + (method == "occlusion" ? 2 : method == "relief" ? 8 : 0);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

}  // namespace

ParallaxNeed measure_need(Gpu& gpu, const Scene& scene, const Camera& camera, glm::uvec2 size, double height_m) {
    ParallaxNeed need;
    for (const char* method : {"flat", "normal", "offset", "offset_limited", "exact"}) need.choices.push_back({method});
    for (const char* method : {"steep", "occlusion", "relief"})
        for (int steps = 4; steps <= 256; steps *= 2) need.choices.push_back({method, steps});
    std::map<const DrawItem*, Maps> maps;
    std::vector<double> parallax_px, texels;
    const dvec3 eye(camera.position), forward = glm::normalize(dvec3(camera.target) - eye);
    const dvec3 right = glm::normalize(glm::cross(forward, dvec3(camera.up))), up = glm::cross(right, forward);
    const double high = std::tan(0.5 * double(camera.fov_y_rad)), wide = high * size.x / size.y;
    const double each = double(size.x) * size.y / (rays.x * rays.y), angle = 2 * high / size.y;  // of a pixel
    for (int y = 0; y < rays.y; ++y)
        for (int x = 0; x < rays.x; ++x) {
            const dvec3 direction = glm::normalize(forward + ((x + 0.5) / rays.x * 2 - 1) * wide * right +
                                                   (1 - (y + 0.5) / rays.y * 2) * high * up);
            const RayHit hit = nearest(scene, eye, direction);
            if (!hit.item) continue;
            for (ParallaxChoice& choice : need.choices) choice.cost += each * other_reads * 1e-6;
            if (!hit.item->maps[MapSlot::height] && !hit.item->maps[MapSlot::normal]) continue;
            auto [entry, added] = maps.try_emplace(hit.item);
            if (added) entry->second = read_maps(gpu, *hit.item);
            const auto probe = probe_at(scene, entry->second, hit, -direction, height_m, angle * hit.distance_m);
            if (!probe) continue;
            const HeightField& field = entry->second.field;
            const double sine = std::sqrt(std::max(0.0, 1 - probe->cosine * probe->cosine));
            if (field.size().x > 1) {
                parallax_px.push_back(height_m * sine / (angle * hit.distance_m));
                texels.push_back(glm::length(probe->along));
            }
            const double depth = field.exact(probe->start, probe->along);
            const dvec3 truth = probe->shade("exact", probe->start + depth * probe->along);
            for (ParallaxChoice& choice : need.choices) {
                choice.cost += each * 1e-6 * reads(choice.method, choice.steps, depth, probe->along);
                if (choice.method == "exact") continue;
                const dvec2 seen = field.place(choice.method, choice.steps, probe->start, probe->along, probe->cosine);
                choice.error += visible(probe->shade(choice.method, seen), truth) / (rays.x * rays.y);
            }
        }
    for (ParallaxChoice& choice : need.choices) choice.error = to_flip(choice.method, choice.error);
    std::stable_sort(need.choices.begin(), need.choices.end(),
                     [](const auto& a, const auto& b) { return a.cost < b.cost; });
    need.parallax_px = median(parallax_px);
    need.texels = median(texels);
    return need;
}

const ParallaxChoice& cheapest_within(const ParallaxNeed& need, double budget) {
    for (const ParallaxChoice& choice : need.choices)
        if (choice.error <= budget) return choice;
    return need.choices.back();  // never: exact has no error
}

std::vector<std::string> explain(const ParallaxNeed& need, const ParallaxChoice& choice, double budget) {
    std::vector<std::string> lines;
    add_line(lines, "depth 1 moves things by %.3g pixels and %.3g texels (medians over what is seen)", need.parallax_px,
             need.texels);
    add_line(
        lines,
        "rule: below half a pixel a normal map will do; beyond, as many steps as bring the hits within the budget");
    for (const ParallaxChoice& c : need.choices)
        add_line(lines, "%-15s steps %d: error %.5f predicted, %.4g million reads", c.method.c_str(), c.steps, c.error,
                 c.cost);
    add_line(lines, "choice: method=%s steps=%d, the cheapest with an error of at most %g", choice.method.c_str(),
             choice.steps, budget);
    return lines;
}

}  // namespace lightwalk
