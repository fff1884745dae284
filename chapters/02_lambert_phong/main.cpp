// Chapter 02: diffuse and specular reflection of directional lights.
#include "01_obj/model_chapter.h"
#include "02_lambert_phong/directional_light.h"
#include "02_lambert_phong/exercises.h"
#include "02_lambert_phong/mist.h"
#include "common/window/run.h"

using namespace lightwalk;

namespace {

// Directional lights of the scene, in order (chapter 03 adds other kinds). Buffers cannot be empty, so a scene without
// lights gets a dark one.
Buffer upload_directional_lights(Gpu& gpu, const std::vector<Light>& lights) {
    std::vector<DirectionalLight> packed;
    for (const Light& light : lights)
        if (light.kind == Light::Kind::directional)
            packed.push_back({-glm::normalize(light.direction), light.color * light.intensity});
    if (packed.empty()) packed.push_back({glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f)});
    return gpu.upload("lights", packed);
}

// Uniform block `mist` of the frame.
void set_mist(Frame& frame, float per_m, glm::vec3 color, const Camera& camera) {
    const Mist air{color, per_m, 0.4f * color * color, 1.0f / camera.near_m, 1.0f / camera.far_m};
    const auto bytes = std::as_bytes(std::span(&air, 1));
    frame.globals["mist"].assign(bytes.begin(), bytes.end());
}

}  // namespace

struct LambertPhong : ModelChapter {
    // [method]
    Choice method{*this,
                  "method",
                  {"gouraud", "phong", "blinn_phong", "blinn_phong_normalised"},
                  "blinn_phong_normalised",
                  "Specular model: gouraud (normalised Blinn–Phong, evaluated at vertices), phong, blinn_phong, or "
                  "Blinn–Phong scaled to conserve energy (blinn_phong_normalised)"};
    // [/method]
    Choice diffuse{*this,
                   "diffuse",
                   {"lambert", "wrapped"},
                   "lambert",
                   "Diffuse model: lambert, or wrapped light that reaches beyond the terminator"};
    Knob<bool> ambient{*this, "ambient", true, "Ambient light of the scene, added to every surface"};
    Knob<float> shininess{
        *this, "shininess", 0.0f, {0.0f, 4096.0f}, "Specular exponent for all materials; 0 keeps each material's own"};
    Knob<float> wrap{
        *this, "wrap", 0.5f, {0.0f, 1.0f}, "Wrap of the diffuse light: 0 is Lambert, 1 lights the whole object"};
    Knob<float> wrap_power{*this, "wrap_power", 1.5f, {0.1f, 8.0f}, "Exponent of the wrapped diffuse term"};
    Knob<glm::vec3> wrap_tint{*this,
                              "wrap_tint",
                              {1.0f, 0.35f, 0.2f},
                              {glm::vec3(0.0f), glm::vec3(1.0f)},
                              "Colour of wrapped light at and beyond the terminator"};

    Knob<float> mist{*this,
                     "mist",
                     0.0f,
                     {0.0f, 2.0f},
                     "Extinction coefficient of the mist, per metre; 0 draws neither mist nor sky",
                     "1/m"};

    Pipeline shade = graphics({.vertex = "02_lambert_phong/shade.vert", .fragment = "02_lambert_phong/shade.frag"});
    Pipeline sky = compute({.shader = "02_lambert_phong/sky.comp"});
    Pipeline fade = compute({.shader = "02_lambert_phong/mist.comp"});
    Buffer lights;

    std::string default_scene() const override { return "scenes/lacquer.json"; }

    void prepare(Gpu& gpu, Scene&) override { lights = upload_directional_lights(gpu, scene.file.lights); }

    // [frame]
    void frame(Frame& frame) override {
        set_view(frame);

        // 1. Shading by every light, in linear HDR.
        const auto draw_scene = [&](Raster& pass) {
            pass.use(shade).set("lights", lights);
            if (ambient) pass.set("ambient", scene.file.ambient);
            pass.draw(scene);
        };
        if (mist > 0.0f) {  // with sky and mist: three passes
            set_mist(frame, mist, scene.file.background, camera);
            record_mist(frame, {sky, fade, draw_scene});
        } else {
            frame.raster("shade",
                         {.color = {clear(frame.hdr, glm::vec4(scene.file.background, 1.0f))}, .depth = frame.depth},
                         draw_scene);
        }

        // 2. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(LambertPhong)
