// Light that arrives at the projected ground beside a post, against its form factor.
#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "../common/module_fixture.h"
#include "01_obj/obj.h"
#include "14_environment/backdrop.h"
#include "common/image/image.h"

using namespace lightwalk;

namespace {

constexpr double half_m = 0.03, height_m = 1;  // of the post

struct OnGround : OnModules {
    GroundShadow shadow{owner, "shadow"};
    Scene scene;

    OnGround() {
        ImageRgb even(256, 128);
        even.pixels.assign(even.pixels.size(), glm::vec3(1.0f));
        const std::filesystem::path picture =
            std::filesystem::temp_directory_path() / fmt::format("lightwalk_even_{}.pfm", getpid());
        write_pfm(picture, even);
        SceneFile file;
        file.environment.image = picture.string();
        SceneObject post;
        post.model = "models/cube.obj";
        post.position = {0, 0.5f, 0};
        post.scale = {float(2 * half_m), float(height_m), float(2 * half_m)};
        file.objects = {post};
        scene.load(gpu, file, [](const auto& model) { return load_model(model); });
        std::filesystem::remove(picture);
        owner.prepare_all(gpu, scene);
    }
    /// Share of the light at a place, as the backdrop reads it: linearly between texels.
    double arriving(glm::dvec2 place, const std::vector<uint64_t>& texels) const {
        const GroundShadowState& state = shadow.state();
        const int side = shadow.resolution;
        const glm::dvec2 at = (place - glm::dvec2(state.corner)) / glm::dvec2(state.extent) * double(side) - 0.5;
        const glm::dvec2 first = glm::floor(at), f = at - first;
        const auto texel = [&](int x, int y) {
            return double(glm::unpackHalf4x16(texels[size_t(int(first.y) + y) * side + size_t(int(first.x) + x)]).g);
        };
        return glm::mix(glm::mix(texel(0, 0), texel(1, 0), f.x), glm::mix(texel(0, 1), texel(1, 1), f.x), f.y);
    }
    /// Mean error within 4 cm of the middle of each side.
    double error() {
        shadow.directions.value = 1024;
        begin({4, 4});
        shadow.record(frame, scene, nullptr, {.cosine = 1, .sine = 0, .intensity = 1}, 0);
        frame.end();
        const auto texels = read<uint64_t>(shadow.arriving);
        double sum = 0;
        int count = 0;
        for (double d = 0.002; d < 0.04; d += 0.002) {
            // Of a rectangle that stands on the ground (J. R. Howell, catalog of configuration factors, B-4).
            const double far = std::hypot(height_m, d);
            const double exact = 1 - (std::atan(half_m / d) - d / far * std::atan(half_m / far)) / glm::pi<double>();
            for (const glm::dvec2 side : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                sum += std::abs(arriving((half_m + d) * side, texels) - exact);
                ++count;
            }
        }
        fmt::print("{} texels: mean error beside a post {:.3f}\n", shadow.resolution.value, sum / count);
        return sum / count;
    }
};

}  // namespace

TEST_CASE_METHOD(OnGround, "what stands on the projected ground touches it: a post's shadow begins at the post",
                 "[14.ground_shadow]") {
    shadow.resolution.value = 256;
    CHECK(error() < 0.08);
    shadow.resolution.value = 64;  // failure: texels as wide as most of the post
    CHECK(error() > 0.12);
}
