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

    Knob<float> above_m{*this,
                        "above_m",
                        0.0f,
                        {0.0f, 1000.0f},
                        "Height above the camera from which the objects that were drawn are shown; 0: the picture",
                        "m"};

    Deferred() {
        objects.gbuffer.method.preferred = true;  // --method is about G-buffers here
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
        if (above_m > 0.0f) show_from_above(frame);

        // 2. sRGB encoding.
        encode_srgb(frame);
    }
    // [/frame]

    // The objects that the picture drew, from behind and above its camera.
    void show_from_above(Frame& frame) {
        const glm::vec3 ahead = camera.target - camera.position;
        const glm::vec3 along = glm::normalize(glm::vec3(ahead.x, 0.0f, ahead.z) + glm::vec3(0.0f, 0.0f, 1e-6f));
        Camera above = camera;
        above.position += above_m.value * glm::vec3(-0.5f * along.x, 1.0f, -0.5f * along.z);
        above.target = camera.position + 0.7f * above_m.value * along;
        above.near_m = std::max(camera.near_m, 0.02f * above_m.value);
        View view = view_of(above, frame);
        view.id = derived_.of(view.id);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 0.0f));
        objects.draw_kept(frame, view, canvas);
    }

    // For the studies: objects drawn; or the size of the G-buffer, and its mean loss of normals and positions.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        if (world.town.objects > 0) {
            for (int again = 0; again < 2; ++again)
                render_linear(*this, gpu, size);  // the first has no frame before it
            error["drawn"] = objects.culling.culls() ? objects.culling.drawn() : scene.opaque().size();
            error["host_ms"] = objects.culling.host_ms();
            return;
        }
        objects.gbuffer.show.set("loss");
        const glm::vec2 lost = mean_loss(render_linear(*this, gpu, size));
        error["bytes_per_pixel"] = objects.gbuffer.bytes_per_pixel();
        error["normal_deg"] = lost.x;
        error["position_mm"] = lost.y;
    }

  private:
    DerivedViews derived_;
};

CHAPTER(Deferred)
