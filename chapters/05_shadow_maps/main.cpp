// Chapter 05: shadow maps, depth as seen from each light.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "05_shadow_maps/lit_scene.h"
#include "05_shadow_maps/rays.h"
#include "05_shadow_maps/sphere_shadow.h"
#include "05_shadow_maps/wrong_shares.h"
#include "common/window/run.h"

using namespace lightwalk;

struct ShadowMaps : ModelChapter {
    LitScene objects{*this, "objects"};
    Rays rays{*this, "rays"};
    SphereShadow sphere_shadow{*this, "sphere_shadow"};
    Choice visibility{
        *this,
        "visibility",
        {"maps", "rays"},
        "maps",
        "Shadows: from shadow maps (maps), or ray traced to points all over each light (rays), the reference"};
    Knob<float> lamp{*this, "lamp", 1.0f, {0.0f, 100.0f}, "Scale factor for all light sizes"};
    Choice show{*this,
                "show",
                {"picture", "visibility", "wrong", "map", "texels"},
                "picture",
                "View: picture, light visibility, errors against rays (wrong: acne red, peter-panning blue, leaks "
                "yellow, edges violet), the map in use, or the size of its texels"};

    SurfacePipelines shown{{.fragment = "05_shadow_maps/shown.frag"}};

    ShadowMaps() {
        objects.shadow.method.alone = true;  // --method is about shadows here
        objects.all_lights = [this](const Frame&) { return lamps(); };
    }
    std::string default_scene() const override { return "scenes/colonnade_evening.json"; }

    // The share of pixels with each kind of wrong shadow, from a picture a quarter as wide: many rays for every pixel.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        show.set("wrong");
        Frame own(gpu);
        render(*this, own, {glm::max(size / 4u, 1u), 0.0f, 0, {}});
        wrong_shares(gpu, own.hdr, error);
    }

    std::vector<Light> lamps() const {
        std::vector<Light> all = scene.lights();
        for (Light& light : all) light.size_m *= lamp, light.size_rad = std::min(light.size_rad * lamp, 1.5f);
        return all;
    }

    // What surfaces are shaded by: rays only where they are asked; a planet and its ring need no map.
    void choose_shading(Frame& frame) {
        const bool asks_rays = visibility.is("rays") || show.is("wrong"), plain = show.is("picture") && !asks_rays;
        sphere_shadow.update(scene);
        objects.shading = sphere_shadow ? &sphere_shadow.ringed : plain ? nullptr : &shown;
        objects.transparent_shading = sphere_shadow ? &sphere_shadow.ringed_transparent : nullptr;
        objects.shading_with.clear();
        if (sphere_shadow) objects.shading_with.push_back(sphere_shadow);
        if (plain) return;
        rays.record(frame, scene, &objects.maps);
        objects.shading_with.push_back(rays);
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame);
        choose_shading(frame);

        // 1. The shadow maps, then every surface, lit by the visible part of each light (lit_scene.cpp).
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 0.0f));
        draw(frame, view, canvas, {objects});

        // 2. Linear light to the codes a screen expects.
        encode_srgb(frame);
    }
    // [/frame]

    std::string why_not_finite() const override { return visibility.is("rays") ? rays.why_not_finite() : ""; }
};

CHAPTER(ShadowMaps)
