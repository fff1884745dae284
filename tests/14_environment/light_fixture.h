// What tests of this chapter share: an environment, and what surfaces in it show.
#pragma once
#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <glm/gtc/packing.hpp>

#include "../common/gpu_fixture.h"
#include "14_environment/image_light.h"
#include "14_environment/truth.h"
#include "common/image/image.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

/// A surface to look at, as 14_environment/image_light.glsl has it, without a place.
struct LookedAt {
    glm::vec3 normal, to_eye, f0;
    float alpha;
};

/// What it shows of a white environment's diffuse light and of its reflections.
struct Shown {
    glm::vec3 diffuse, specular, diffuse_share;
};

struct OnLight : OnDevice {
    struct Owner : Module {
    } owner;
    ImageLight light{owner, "environment"};
    Scene scene;
    std::vector<std::filesystem::path> made;
    Pipeline look = compute_pipeline("look at surfaces", R"(
#include "14_environment/image_light.glsl"
#include "14_environment/unoccluded.glsl"
layout(local_size_x = 64) in;
struct LookedAt { vec3 normal, to_eye, f0; float alpha; };
struct Shown { vec3 diffuse, specular, diffuse_share; };
layout(scalar) readonly buffer LookedAtBuffer { LookedAt looked_at[]; };
layout(scalar) writeonly buffer ShownBuffer { Shown shown[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(looked_at.length())) return;
    LookedAt s = looked_at[i];
    FromAround r = reflected_from_around(LitFromAround(vec3(0.0), s.normal, s.to_eye, s.f0, s.alpha));
    shown[i] = Shown(diffuse_light(vec3(0.0), s.normal), r.specular, r.diffuse_share);
})");

    ~OnLight() {
        for (const auto& file : made) std::filesystem::remove(file);
    }

    void load(const std::string& image, glm::vec3 ambient = glm::vec3(0.5f)) {
        SceneFile file;
        file.ambient = ambient;
        if (!image.empty()) file.environment.image = image;
        scene.load(gpu, file, [](const auto&) -> Model { return {}; });
        owner.begin_frame(gpu, {4, 4});
        light.prepare(gpu, scene);
        light.record(frame, scene);
    }

    /// Of a picture that is given by its radiance along each direction.
    void load(int width, int height, const std::function<glm::dvec3(glm::dvec3)>& radiance) {
        ImageRgb picture(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                picture.at(x, y) = glm::vec3(radiance(truth::direction_at({(x + 0.5) / width, (y + 0.5) / height})));
        made.push_back(std::filesystem::temp_directory_path() /
                       fmt::format("lightwalk_light_{}_{}.pfm", getpid(), made.size()));
        write_pfm(made.back(), picture);
        load(made.back().string());
    }

    std::vector<Shown> shown(const std::vector<LookedAt>& surfaces) {
        const Buffer in = gpu.upload("looked at", surfaces);
        const Buffer out(gpu.device, {.name = "shown", .bytes = sizeof(Shown) * surfaces.size()});
        light.record(frame, scene);
        frame.compute("look", {.reads = {in}, .writes = {out}, .with = {light}}, [&](Compute& pass) {
            pass.use(look).set("looked_at", in).set("shown", out);
            pass.dispatch_threads(glm::uvec2(static_cast<uint32_t>(surfaces.size()), 1));
        });
        frame.end();
        const auto found = read<Shown>(out);
        frame.begin({4, 4}, 0);
        owner.begin_frame(gpu, {4, 4});
        return found;
    }

    /// What a white matt surface of each normal shows.
    std::vector<glm::vec3> diffuse(const std::vector<glm::vec3>& normals) {
        std::vector<LookedAt> surfaces;
        for (const glm::vec3 n : normals) surfaces.push_back({n, n, glm::vec3(0), 1.0f});
        std::vector<glm::vec3> light_of;
        for (const Shown& one : shown(surfaces)) light_of.push_back(one.diffuse);
        return light_of;
    }
};

inline bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Evenly over the sphere, and the six axes.
inline std::vector<glm::vec3> all_around(int count = 60) {
    std::vector<glm::vec3> directions{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < count; ++i) {
        const double y = 1 - (2 * i + 1) / double(count), turn = 2.399963 * i;
        directions.push_back(
            glm::dvec3(std::sqrt(1 - y * y) * std::cos(turn), y, std::sqrt(1 - y * y) * std::sin(turn)));
    }
    return directions;
}

/// Irradiance over pi: every texel with its solid angle.
inline std::vector<glm::dvec3> true_diffuse(const ImageRgb& picture, const std::vector<glm::vec3>& normals) {
    std::vector<glm::dvec3> sums(normals.size(), glm::dvec3(0));
    for (int y = 0; y < picture.height; ++y) {
        const double solid_angle = truth::equirect_solid_angle(y, picture.width, picture.height);
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec3 l = truth::direction_at({(x + 0.5) / picture.width, (y + 0.5) / double(picture.height)});
            const glm::dvec3 arriving = solid_angle * 2 / truth::around * glm::dvec3(picture.at(x, y));
            for (size_t i = 0; i < normals.size(); ++i)
                sums[i] += arriving * std::max(0.0, glm::dot(glm::dvec3(normals[i]), l));
        }
    }
    return sums;
}

}  // namespace lightwalk
