// Chapter 03: point and spot lights, and how not to compute those that do not reach.
#include "01_obj/model_chapter.h"
#include "03_attenuation/light_buffer.h"

using namespace lightwalk;

struct Attenuation : ModelChapter {
    Choice falloff{"falloff",
                   {"range_fade", "inverse_square_window", "inverse_square"},
                   "inverse_square_window",
                   "how light weakens with distance"};
    Knob<float> fade_k{"fade_k", 1.0f, {0.0f, 100.0f}, "k of range_fade", "1/m²"};

    Pipeline shade = graphics({.vertex = "03_attenuation/surface.vert", .fragment = "03_attenuation/shade.frag"});
    LightBuffer lights;

    std::string default_scene() const override { return "scenes/night.json"; }

    void frame(Frame& frame) override {
        set_view(frame);
        lights.update(frame.gpu, scene.file.lights);
        frame.raster("shade",
                     {.color = {frame.hdr}, .depth = frame.depth, .clear = glm::vec4(scene.file.background, 1.0f)},
                     [&](Raster& pass) {
                         pass.use(shade).set("lights", lights.buffer).set("ambient", scene.file.ambient).draw(scene);
                     });
        encode_srgb(frame);
    }
};

CHAPTER(Attenuation)
