// Shared by the tests of this chapter: an environment, and surfaces in it.
#pragma once
#include <filesystem>
#include <functional>

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
    glm::vec3 body{0};
    uint32_t has_metalness = 0;
};

/// Radiance of a white matt surface of its normal, its reflection, and its share of entering light.
struct Shown {
    glm::vec3 diffuse, specular, diffuse_share;
};

struct OnLight : OnDevice {
    struct Owner : Module {
    } owner;
    ImageLight light{owner, "environment"};
    Scene scene;
    std::vector<std::filesystem::path> made;  ///< files to remove
    Pipeline look;

    OnLight();
    ~OnLight();

    void load(const std::string& image, glm::vec3 ambient = glm::vec3(0.5f));
    /// Of a picture that is given by its radiance along each direction.
    void load(int width, int height, const std::function<glm::dvec3(glm::dvec3)>& radiance);

    /// Copies the picture into the cube of `light.drawn` and filters it, as if its radiance had been drawn.
    void draw_picture();

    std::vector<Shown> shown(const std::vector<LookedAt>& surfaces);
    /// The same without record(): in the light that is chosen. Ends the frame and begins another.
    std::vector<Shown> shown_now(const std::vector<LookedAt>& surfaces);
    /// Radiance of a white matt surface of each normal.
    std::vector<glm::vec3> diffuse(const std::vector<glm::vec3>& normals);
};

inline bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Evenly over the sphere, and the six axes.
std::vector<glm::vec3> all_around(int count = 60);

/// Irradiance over pi: every texel with its solid angle.
std::vector<glm::dvec3> true_diffuse(const ImageRgb& picture, const std::vector<glm::vec3>& normals);

}  // namespace lightwalk
