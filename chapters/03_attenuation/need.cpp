#include "03_attenuation/need.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "02_lambert_phong/need.h"
#include "02_lambert_phong/truth.h"
#include "03_attenuation/exercises.h"
#include "03_attenuation/light_grid.h"
#include "03_attenuation/truth.h"
#include "03_attenuation/visible_points.h"
#include "common/base/add_line.h"

namespace lightwalk {
namespace {

using glm::dvec3;

constexpr glm::uvec2 grid{32, 18};  // points looked at
constexpr float thresholds[] = {0.256f, 0.064f, 0.016f, 0.004f, 0.001f};

// In lights computed for a pixel: what a pixel pays for its list, and a cell for asking whether a light reaches it, as
// the study found it on an H200. There the list of an object costs 0.2; the rest is for making it on the CPU.
constexpr double list_cost = 2.0, masks_cost = 1.5, tile_depth_cost = 0.1, test_cost = 0.05;

Bounds around(const VisiblePoint& point, float half_m) { return {point.position - half_m, point.position + half_m}; }

class Survey {
  public:
    Survey(const Scene& scene, const Camera& camera, glm::uvec2 size, const std::vector<Light>& lights, int slices)
        : scene_(scene), camera_(camera), size_(size), lights_(lights), slices_(slices) {
        points_ = visible_points(scene, camera, float(size.x) / float(size.y), grid);
        pixels_ = double(size.x) * size.y * double(points_.size()) / (grid.x * grid.y);
    }

    // Means over the points, for lights that are taken to end at these radii.
    struct Counts {
        double reach = 0, object = 0, tile = 0, cluster = 0;
    };
    Counts count(const std::vector<float>& radii_m) const {
        Counts sum;
        std::map<uint32_t, size_t> of_item;
        const auto reaching = [&](const Bounds& box) {
            size_t found = 0;
            for (size_t i = 0; i < lights_.size(); ++i) found += light_reaches_box(lights_[i], radii_m[i], box);
            return found;
        };
        const glm::vec2 depths = cluster_depths(camera_, scene_.bounds);
        const float slice_share = std::pow(depths.y / depths.x, 1.0f / float(slices_)) - 1.0f;
        for (const VisiblePoint& point : points_) {
            const auto item = of_item.try_emplace(point.item, 0);
            if (item.second) item.first->second = reaching(scene_.items[point.item].bounds);
            sum.object += double(item.first->second);
            sum.reach += double(reaching(around(point, 0.0f)));
            // A cell is about as good as a cube of its mean side. What a tile holds lies along the surface.
            const float pixel_m = 2.0f * std::tan(0.5f * camera_.fov_y_rad) * point.depth_m / float(size_.y);
            const float facing = std::fabs(glm::dot(point.normal, glm::normalize(point.position - camera_.position)));
            const float tile_m = pixel_m * float(tile_px), column_m = pixel_m * float(cluster_px);
            const float tile_depth_m = tile_m * std::sqrt(1.0f - facing * facing) / std::max(facing, 0.05f);
            sum.tile += double(reaching(around(point, (2.0f * tile_m + tile_depth_m) / 6.0f)));
            sum.cluster += double(reaching(around(point, (2.0f * column_m + slice_share * point.depth_m) / 6.0f)));
        }
        const double n = std::max<double>(1, double(points_.size()));
        return {sum.reach / n, sum.object / n, sum.tile / n, sum.cluster / n};
    }

    // Predicted mean FLIP for each threshold: what is lost of the lights that end too early, at every point. Cells keep
    // more than that, never less.
    std::vector<double> errors() const {
        std::vector<double> sum(std::size(thresholds));
        for (const VisiblePoint& point : points_) {
            dvec3 truth(scene_.file.ambient);
            truth *= dvec3(scene_.items[point.item].material.diffuse);
            std::vector<dvec3> lost(std::size(thresholds), dvec3(0.0));
            for (const Light& light : lights_) {
                const dvec3 reflected = reflect(light, point);
                truth += reflected;
                if (light.kind == Light::Kind::directional) continue;
                for (size_t k = 0; k < lost.size(); ++k)
                    if (glm::distance(light.position, point.position) > influence_radius(pack(light), thresholds[k]))
                        lost[k] += reflected;
            }
            for (size_t k = 0; k < lost.size(); ++k) sum[k] += expected_flip(truth - lost[k], truth);
        }
        for (double& error : sum) error /= grid.x * grid.y;
        return sum;
    }

    double pixels() const { return pixels_; }
    double cells(uint32_t side_px, int slices) const {
        const glm::uvec2 tiles = (size_ + side_px - 1u) / side_px;
        return double(tiles.x) * tiles.y * slices;
    }

  private:
    dvec3 reflect(const Light& light, const VisiblePoint& point) const {
        const Material& material = scene_.items[point.item].material;
        const dvec3 normal(point.normal), to_eye = glm::normalize(dvec3(camera_.position) - dvec3(point.position));
        dvec3 to_light = -dvec3(light.direction), radiance(light.color * light.intensity);
        if (light.kind != Light::Kind::directional)
            radiance = truth::arriving_inverse_square(light, point.position, to_light);
        const double received = truth::lambert(normal, to_light);
        const double shininess = double(material.shininess);
        const double lobe = truth::blinn_phong(normal, to_light, to_eye, shininess) *
                            truth::blinn_phong_normalisation(shininess) * received;
        return radiance * (dvec3(material.diffuse) * received + dvec3(material.specular) * lobe);
    }
    const Scene& scene_;
    const Camera& camera_;
    glm::uvec2 size_;
    const std::vector<Light>& lights_;
    int slices_;
    std::vector<VisiblePoint> points_;
    double pixels_ = 0;
};

}  // namespace

CullingNeed measure_culling(const Scene& scene, const Camera& camera, glm::uvec2 size, const std::vector<Light>& lights,
                            int slices, bool endless) {
    const Survey survey(scene, camera, size, lights, slices);
    const double n = double(lights.size()), pixels = survey.pixels();
    CullingNeed need{.lights = lights.size()};
    need.choices.push_back({"every_light", 0, 0, pixels * n * 1e-6});
    const std::vector<double> errors = endless ? survey.errors() : std::vector<double>{0.0};
    for (size_t k = 0; k < errors.size(); ++k) {
        const float threshold = endless ? thresholds[k] : 0.0f;
        std::vector<float> radii_m;
        for (const Light& light : lights) radii_m.push_back(influence_radius(pack(light), threshold));
        const Survey::Counts counts = survey.count(radii_m);
        need.lights_per_pixel = counts.reach;
        const double groups = std::ceil(n / LIGHTS_PER_GROUP);
        const auto add = [&](const char* method, double per_pixel, double cells) {
            need.choices.push_back({method, threshold, errors[k], (pixels * per_pixel + cells * n * test_cost) * 1e-6});
        };
        add("per_object", counts.object + list_cost, 0);
        add("tiled", counts.tile + masks_cost * groups + tile_depth_cost, survey.cells(tile_px, 1));
        add("clustered", counts.cluster + masks_cost * groups, survey.cells(cluster_px, slices));
    }
    std::stable_sort(need.choices.begin(), need.choices.end(),
                     [](const auto& a, const auto& b) { return a.cost < b.cost; });
    return need;
}

const CullingChoice& cheapest_within(const CullingNeed& need, double budget) {
    return *std::find_if(need.choices.begin(), need.choices.end(),
                         [&](const CullingChoice& choice) { return choice.error <= budget; });
}

std::vector<std::string> explain(const CullingNeed& need, const CullingChoice& choice, double budget) {
    std::vector<std::string> lines;
    const double n = std::max(1.0, double(need.lights));
    add_line(lines, "lights: %zu; of them reach a pixel: %.3g in the mean, a share of %.3g", need.lights,
             need.lights_per_pixel, need.lights_per_pixel / n);
    add_line(lines, "rule: a share near 1, or a handful of lights, does not pay for culling; few of many do");
    for (const CullingChoice& c : need.choices)
        if (c.threshold > 0)
            add_line(lines, "%-12s threshold %g: error %.5f predicted, %.4g million lights computed", c.method.c_str(),
                     double(c.threshold), c.error, c.cost);
        else
            add_line(lines, "%-12s : error %.5f predicted, %.4g million lights computed", c.method.c_str(), c.error,
                     c.cost);
    char set[64] = "";
    if (choice.threshold > 0) std::snprintf(set, sizeof set, " threshold=%g", double(choice.threshold));
    add_line(lines, "choice: method=%s%s, the cheapest with an error of at most %g", choice.method.c_str(), set,
             budget);
    return lines;
}

}  // namespace lightwalk
