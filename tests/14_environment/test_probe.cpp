// Surroundings that are drawn: where a probe's faces look, when they are drawn, and how a box turns lookups.
#include "14_environment/backdrop.h"
#include "14_environment/probe.h"
#include "light_fixture.h"

using namespace lightwalk;

namespace {

/// Shows of each direction half of it plus a half, as red, green and blue; counts its views.
struct Directions : Drawing {
    using Drawing::Drawing;
    int views = 0;
    void draw(Frame& frame, const View& view, Canvas& canvas) override {
        ++views;
        const ImageView result = canvas.color_overwritten();
        frame.compute("directions", {.writes = {result}}, [&](Compute& pass) {
            pass.use(fill_).set("rays", view_rays(view)).set("result", result);
            pass.dispatch_threads(glm::uvec2(result.size()));
        });
    }

  private:
    Pipeline fill_ = compute_pipeline("directions", R"(
#include "common/view_rays.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(rgba16f) writeonly uniform image2D result;
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    imageStore(result, pixel, vec4(0.5 + 0.5 * normalize(ray_through(rays, vec2(pixel) + 0.5)), 1.0));
})");
};

struct OnProbe : OnLight {
    SceneProbe probe{owner, "probe"};
    Directions directions{owner, "directions"};
    void record() { probe.record(frame, scene, light, {directions}); }
    void next_frame() {
        frame.end();
        frame.begin({4, 4}, 0);
        owner.begin_frame(gpu, {4, 4});
        light.record(frame, scene);
    }
};

}  // namespace

TEST_CASE_METHOD(OnProbe, "a probe sees each direction where the cube is looked up along it") {
    load("");
    light.method.set("mirror");
    probe.update.set("always");
    probe.box.set("off");
    record();
    CHECK(directions.views == 6);
    std::vector<LookedAt> mirrors;
    for (const glm::vec3 n : all_around()) mirrors.push_back({n, n, glm::vec3(1), 0.0f});
    const auto found = shown_now(mirrors);
    for (size_t i = 0; i < mirrors.size(); ++i) {
        CHECK(glm::length(glm::dvec3(found[i].specular) - (0.5 * glm::dvec3(mirrors[i].normal) + 0.5)) < 0.01);
        CHECK(glm::length(glm::dvec3(found[i].diffuse) - (glm::dvec3(mirrors[i].normal) / 3.0 + 0.5)) < 0.02);
    }
}

TEST_CASE_METHOD(OnProbe, "a probe is drawn in each frame, or where something has changed, or a face at a time") {
    load("");
    probe.update.set("moved");
    record();
    CHECK(probe.drawn_faces == 6);
    next_frame();
    record();
    CHECK(probe.drawn_faces == 0);
    probe.center.value.x += 1;
    next_frame();
    record();
    CHECK(probe.drawn_faces == 6);
    light.turn_deg.value += 90;  // another module's knob, which its picture depends on
    next_frame();
    record();
    CHECK(probe.drawn_faces == 6);
    probe.update.set("face");
    for (int i = 0; i < 3; ++i) {
        next_frame();
        record();
        CHECK(probe.drawn_faces == 1);
    }
    probe.update.set("always");
    next_frame();
    record();
    CHECK(probe.drawn_faces == 6);
    probe.update.set("off");
    next_frame();
    record();
    CHECK(probe.drawn_faces == 0);
    CHECK(directions.views == 6 + 6 + 6 + 3 + 6);
}

TEST_CASE("directions that stand for equal shares of light: their weights add up, and a sun gets its part") {
    ImageRgb picture(64, 32, glm::vec3(1));
    picture.at(40, 4) = glm::vec3(5000);
    const auto lights = ground_lights(picture, {.cosine = 1, .sine = 0, .intensity = 1}, 64);
    REQUIRE(lights.size() == 64);
    glm::vec3 sum(0);
    const glm::dvec3 sun = truth::direction_at({40.5 / 64, 4.5 / 32});
    int at_sun = 0;
    for (const GroundLight& one : lights) {
        sum += one.share;
        CHECK(one.to_light.y > 0);
        at_sun += glm::dot(sun, glm::dvec3(one.to_light)) > 0.9999;
    }
    CHECK(glm::length(sum - glm::vec3(1)) < 1e-3f);
    // Its texel's share: 5000 of it against the sky's pi.
    const double share = 5000 * truth::equirect_solid_angle(4, 64, 32) * sun.y;
    CHECK(at_sun == Approx(64 * share / (share + 3.14159)).margin(2));
    CHECK(ground_lights(ImageRgb(8, 4), {.cosine = 1, .sine = 0, .intensity = 1}, 16).empty());
}
