// Chapter 06: deferred shading, surfaces stored first and lit afterwards.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "06_deferred/many_lights.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Deferred : ModelChapter {
    ManyLights world{*this};
    DeferredScene& objects = world.objects;
    Choice cull{*this,
                "cull",
                {"fixed", "geometry", "none", "left_out"},
                "fixed",
                "Back-face culling in the G-buffer pass: by the device (fixed), by a geometry shader (geometry), none, "
                "or only the triangles that geometry removes (left_out)"};
    Knob<int> overdraw{*this, "overdraw", 1, {1, 64}, "Overdraw: number of times each surface is drawn"};
    Knob<bool> prepass{*this, "prepass", false, "Depth prepass, so that each pixel is shaded or written once"};

    Deferred() {
        objects.gbuffer.method.alone = true;  // --method is about G-buffers here
    }
    std::string default_scene() const override { return "scenes/hundred_lamps.json"; }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame, world);
        objects.cull = static_cast<DeferredScene::Cull>(cull.index);
        objects.times = overdraw;
        objects.depth_first = prepass;

        // 1. The pictures on the screens of the scene, then a G-buffer and its lighting (many_lights.h, deferred_scene.cpp).
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 0.0f));
        world.draw_light(frame, view, canvas);

        // 2. sRGB encoding.
        encode_srgb(frame);
    }
    // [/frame]

    // For the study: the size of the G-buffer, and its mean loss of normals and positions over the picture.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        objects.gbuffer.show.set("loss");
        const glm::vec2 lost = mean_loss(render_linear(*this, gpu, size));
        error["bytes_per_pixel"] = objects.gbuffer.bytes_per_pixel();
        error["normal_deg"] = lost.x;
        error["position_mm"] = lost.y;
    }
};

CHAPTER(Deferred)
