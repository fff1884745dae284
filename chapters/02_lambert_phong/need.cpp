#include "02_lambert_phong/need.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "02_lambert_phong/truth.h"
#include "common/base/add_line.h"
#include "common/image/image.h"
#include "common/measure/statistics.h"

namespace lightwalk {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr size_t most_triangles = 4000;  // looked at, evenly spread over the scene's
constexpr int reference_samples = 6;

// How FLIP's mean follows from the difference of sRGB codes: FLIP's colour term is a power of 0.7 of the distance (its
// qc). The factors make up for what the triangles' three points and FLIP's filters change: each is the largest ratio of
// measured to predicted error over the teapot, statue and glossy scenes (./course study 02), rounded up.
constexpr double flip_power = 0.7;
constexpr double gouraud_factor = 1.7, model_factor = 2.5, sampling_factor = 2.5;

double factor(const std::string& method) {
    return method == "gouraud" ? gouraud_factor : method == "blinn_phong_normalised" ? sampling_factor : model_factor;
}

struct Corner2 {
    dvec3 position, normal;
    dvec2 pixel;
};

struct Item {
    dvec3 diffuse, specular;
    double shininess;
};

struct Context {
    std::vector<Light> lights;
    dvec3 ambient, eye;

    dvec3 shade(const Item& item, const std::string& method, dvec3 position, dvec3 normal) const {
        normal = glm::normalize(normal);
        const dvec3 to_eye = glm::normalize(eye - position);
        dvec3 sum = item.diffuse * ambient;
        for (const Light& light : lights) {
            if (light.kind != Light::Kind::directional) continue;
            const dvec3 to_light = -dvec3(light.direction);
            const double received = truth::lambert(normal, to_light);
            double lobe = 0;
            if (method == "phong")
                lobe = truth::phong(normal, to_light, to_eye, 0.25 * item.shininess);
            else
                lobe = truth::blinn_phong(normal, to_light, to_eye, item.shininess);
            if (method == "blinn_phong_normalised") lobe *= truth::blinn_phong_normalisation(item.shininess) * received;
            sum += dvec3(light.color * light.intensity) * (item.diffuse * received + item.specular * lobe);
        }
        return sum;
    }
};

// A triangle on the screen: what each method shows in it, against the mean over the pixel.
class Triangle {
  public:
    Triangle(const Context& context, const Item& item, std::array<Corner2, 3> corners)
        : context_(context), item_(item), c_(corners) {
        const dvec2 e1 = c_[1].pixel - c_[0].pixel, e2 = c_[2].pixel - c_[0].pixel;
        const double det = e1.x * e2.y - e1.y * e2.x;
        area = 0.5 * std::fabs(det);
        // Change of barycentric coordinates from pixel to pixel.
        if (area > 0) dx_ = dvec2(e2.y, -e1.y) / det, dy_ = dvec2(-e2.x, e1.x) / det;
    }
    double area = 0;  // pixels

    // The angle by which the normal turns over one pixel.
    double turn_per_pixel() const {
        const dvec3 n1 = c_[1].normal - c_[0].normal, n2 = c_[2].normal - c_[0].normal;
        return std::max(glm::length(n1 * dx_.x + n2 * dx_.y), glm::length(n1 * dy_.x + n2 * dy_.y));
    }
    dvec3 at(const std::string& method, dvec2 b) const {
        const double a = 1 - b.x - b.y;
        return context_.shade(item_, method, a * c_[0].position + b.x * c_[1].position + b.y * c_[2].position,
                              a * c_[0].normal + b.x * c_[1].normal + b.y * c_[2].normal);
    }
    dvec3 sampled(const std::string& method, dvec2 b, int samples) const {
        dvec3 sum(0.0);
        for (int y = 0; y < samples; ++y)
            for (int x = 0; x < samples; ++x)
                sum += at(method, b + ((x + 0.5) / samples - 0.5) * dx_ + ((y + 0.5) / samples - 0.5) * dy_);
        return sum / double(samples * samples);
    }
    dvec3 gouraud(dvec2 b) const {
        const std::string model = "blinn_phong_normalised";
        return (1 - b.x - b.y) * at(model, {0, 0}) + b.x * at(model, {1, 0}) + b.y * at(model, {0, 1});
    }

  private:
    const Context& context_;
    const Item& item_;
    std::array<Corner2, 3> c_;
    dvec2 dx_{0}, dy_{0};
};

}  // namespace

double expected_flip(dvec3 shown, dvec3 truth) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const auto code = [](double linear) {
            return static_cast<double>(linear_to_srgb(static_cast<float>(std::clamp(linear, 0.0, 1.0))));
        };
        sum += std::fabs(code(shown[i]) - code(truth[i])) / 3;
    }
    // One 8-bit step of grey is 0.03 (docs/study_format.md).
    return std::min(1.0, 0.03 * std::pow(sum * 255.0, flip_power));
}

ShadingNeed measure_need(const Scene& scene, const glm::mat4& view_projection, glm::vec3 eye, glm::uvec2 size,
                         float shininess) {
    ShadingNeed need;
    for (const char* method : {"gouraud", "phong", "blinn_phong"}) need.choices.push_back({method, 1});
    for (int samples = 1; samples <= 4; ++samples) need.choices.push_back({"blinn_phong_normalised", samples});
    const Context context{scene.file.lights, scene.file.ambient, eye};
    const size_t stride = std::max<size_t>(1, scene.triangle_count() / most_triangles);
    std::vector<std::array<double, 3>> seen;  // area, triangle side, highlight width
    double covered = 0, vertices = 0;
    size_t count = 0;
    for (const DrawItem& draw : scene.items) {
        const Mesh& mesh = draw.model->model.meshes[draw.mesh];
        const Part& part = mesh.parts[draw.part];
        const Item item{draw.material.diffuse, draw.material.specular,
                        double(shininess > 0 ? shininess : draw.material.shininess)};
        const glm::mat3 normal_matrix = glm::transpose(glm::inverse(glm::mat3(draw.transform)));
        vertices += static_cast<double>(mesh.vertices.size());
        for (uint32_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3) {
            if (count++ % stride) continue;
            std::array<Corner2, 3> corners;
            bool inside = true;
            for (size_t k = 0; k < 3; ++k) {
                const Vertex& v = mesh.vertices[mesh.indices[i + k]];
                const glm::vec4 world = draw.transform * glm::vec4(v.position, 1.0f);
                const glm::vec4 clip = view_projection * world;
                inside = inside && clip.w > 0 && std::fabs(clip.x) < clip.w && std::fabs(clip.y) < clip.w;
                corners[k] = {dvec3(world), dvec3(glm::normalize(normal_matrix * v.normal)),
                              dvec2(0.5 * double(clip.x / clip.w) * size.x, 0.5 * double(clip.y / clip.w) * size.y)};
            }
            const dvec3 face =
                glm::cross(corners[1].position - corners[0].position, corners[2].position - corners[0].position) *
                (draw.mirrored ? -1.0 : 1.0);
            if (!inside || glm::dot(face, context.eye - corners[0].position) <= 0) continue;
            const Triangle triangle(context, item, corners);
            if (triangle.area < 1e-6) continue;
            covered += triangle.area;
            // Full width at half maximum of the lobe, as an angle of the normal: 2 acos(2^(-1/n)).
            const double lobe = 2 * std::acos(std::exp2(-1 / std::max(item.shininess, 0.5)));
            seen.push_back(
                {triangle.area, std::sqrt(2 * triangle.area), lobe / std::max(triangle.turn_per_pixel(), 1e-9)});
            for (const dvec2 b : {dvec2(1. / 6, 1. / 6), dvec2(2. / 3, 1. / 6), dvec2(1. / 6, 2. / 3)}) {
                const dvec3 truth = triangle.sampled("blinn_phong_normalised", b, reference_samples);
                for (ShadingChoice& choice : need.choices) {
                    const dvec3 shown = choice.method == "gouraud" ? triangle.gouraud(b)
                                                                   : triangle.sampled(choice.method, b, choice.samples);
                    choice.error += expected_flip(shown, truth) * triangle.area / 3 * factor(choice.method);
                }
            }
        }
    }
    const double pixels = double(size.x) * size.y, scale = static_cast<double>(stride);
    for (ShadingChoice& choice : need.choices) {
        choice.error *= scale / pixels;
        choice.cost =
            choice.method == "gouraud" ? vertices * 1e-6 : covered * scale * choice.samples * choice.samples * 1e-6;
        // Without the factor a little is saved.
        if (choice.method == "phong" || choice.method == "blinn_phong") choice.cost *= 0.98;
    }
    std::stable_sort(need.choices.begin(), need.choices.end(),
                     [](const auto& a, const auto& b) { return a.cost < b.cost; });
    const auto median_of = [&](size_t which) {
        std::sort(seen.begin(), seen.end(), [&](const auto& a, const auto& b) { return a[which] < b[which]; });
        double sum = 0;
        for (const auto& s : seen)
            if ((sum += s[0]) >= 0.5 * covered) return s[which];
        return 0.0;
    };
    need.triangle_px = median_of(1);
    need.highlight_px = median_of(2);
    return need;
}

const ShadingChoice& cheapest_within(const ShadingNeed& need, double budget) {
    for (const ShadingChoice& choice : need.choices)
        if (choice.error <= budget) return choice;
    return *std::min_element(need.choices.begin(), need.choices.end(),
                             [](const auto& a, const auto& b) { return a.error < b.error; });
}

std::vector<std::string> explain(const ShadingNeed& need, const ShadingChoice& choice, double budget) {
    std::vector<std::string> lines;
    add_line(lines, "highlight width: %.3g pixels; triangle side: %.3g pixels (medians over what is seen)",
             need.highlight_px, need.triangle_px);
    add_line(lines,
             "rule: highlights wider than triangles bear shading at vertices; below a pixel they need several samples");
    for (const ShadingChoice& c : need.choices)
        add_line(lines, "%-24s samples %d: error %.5f predicted, %.4g million evaluations", c.method.c_str(), c.samples,
                 c.error, c.cost);
    add_line(lines, "choice: method=%s samples=%d, the cheapest with an error of at most %g%s", choice.method.c_str(),
             choice.samples, budget, choice.error <= budget ? "" : " would be none: this is the most accurate");
    return lines;
}

}  // namespace lightwalk
