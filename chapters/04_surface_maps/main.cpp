// Chapter 04: surfaces that textures describe: their slope, their depth, their substance, their holes.
#include "01_obj/model_chapter.h"
#include "03_attenuation/light_buffer.h"
#include "04_surface_maps/maps.h"
#include "04_surface_maps/need.h"
#include "04_surface_maps/tangents.h"
#include "common/study/study.h"

using namespace lightwalk;

struct SurfaceMaps : ModelChapter {
    // [method]
    Choice method{"method",
                  {"flat", "normal", "offset", "offset_limited", "steep", "occlusion", "relief", "exact"},
                  "occlusion",
                  "how a surface's bumps are shown; from offset on, where the eye's ray meets the height map"};
    // [/method]
    Knob<int> steps{"steps", 32, {1, 4096}, "how often steep, occlusion and relief look at the height map"};
    Knob<float> height_m{"height_m", 0.05f, {0.0f, 1.0f}, "how deep black lies in a height map", "m"};
    Choice mesh{"mesh", {"loaded", "displaced"}, "loaded", "displaced: the height map moves a finely cut mesh"};
    Knob<int> subdivide{"subdivide", 16, {1, 1024}, "into how many a displaced triangle's edge is cut"};
    Knob<float> strength{"strength", 1.0f, {0.0f, 4.0f}, "by what the slope in normal maps is multiplied"};
    Knob<float> detail_tiles{"detail_tiles", 8.0f, {0.0f, 64.0f}, "how often detail repeats in a texture's width"};
    Choice normal_y{"normal_y", {"up", "down"}, "up", "where green points in normal maps: up (OpenGL), down (DirectX)"};
    Choice filter{"filter", {"renormalised", "toksvig"}, "toksvig", "what far away normal maps do to highlights"};
    Choice coverage{"coverage", {"kept", "averaged"}, "kept", "how alpha is made smaller: averaged lets leaves vanish"};
    Knob<float> cutoff{"cutoff", 0.5f, {0.0f, 1.0f}, "what has less alpha is cut out"};
    Knob<float> wobble{"wobble", 0.0f, {0.0f, 0.2f}, "how far textures swing, in texture widths"};
    Knob<float> scroll{"scroll", 0.0f, {-2.0f, 2.0f}, "how far textures flow, in texture widths a second"};
    Knob<int> samples{"samples", 1, {1, 16}, "shading samples a pixel, along each side"};
    Choice show{"show",
                {"shaded", "hit_error", "swim", "normal"},
                "shaded",
                "hit_error, and its change when the eye moves, are in texels of the height map; 32 are white"};
    MapSwitches maps;

    Pipeline surface = graphics({.vertex = "04_surface_maps/surface.vert", .fragment = "04_surface_maps/surface.frag"});
    Pipeline displaced =
        graphics({.vertex = "04_surface_maps/displaced.vert", .fragment = "04_surface_maps/surface.frag"});
    LightBuffer lights;
    Gpu* device = nullptr;  ///< that the scene was prepared for

    std::string default_scene() const override { return "scenes/castle_wall.json"; }
    bool reload_on_toggle() const override { return true; }
    std::string load_key() const override { return coverage.is("kept") ? cutoff.text() : coverage.text(); }
    bool animated() const override { return wobble > 0 || scroll != 0; }

    void prepare(Gpu& gpu) override {
        device = &gpu;
        lights.update(gpu, scene.file.lights);
        add_tangents(gpu, scene);
        make_mips(gpu, scene, coverage.is("kept") ? cutoff : -1.0f);
    }

    std::vector<std::string> choose(double budget, glm::uvec2 size) override {
        const ParallaxNeed need = measure_need(*device, scene, camera, size, height_m);
        const ParallaxChoice& choice = cheapest_within(need, budget);
        method.set(choice.method);
        steps.set(std::to_string(choice.steps));
        return explain(need, choice, budget);
    }

    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        const auto mean_of = [&](const char* shown) {
            show.set(shown);
            Frame own(gpu);
            render(*this, own, size, 0.0f, 0);
            return mean_texels(read_hdr(gpu, own.hdr));
        };
        error["hit_texels"] = mean_of("hit_error");
        error["swim_texels"] = mean_of("swim");
    }

    // [frame]
    void frame(Frame& frame) override {
        set_view(frame);
        const bool measures = show.is("hit_error") || show.is("swim");
        const glm::vec4 behind(measures ? glm::vec3(-1.0f) : scene.file.background, 1.0f);

        // 1. Every surface, each by the variant that has just its maps.
        frame.raster("shade", {.color = {clear(frame.hdr, behind)}, .depth = frame.depth}, [&](Raster& pass) {
            for (const DrawItem& item : scene.items) {
                maps.define(frame.gpu.pipelines.defines, item);
                pass.use(mesh.is("displaced") ? displaced : surface);
                pass.set("lights", lights.buffer).set("ambient", scene.file.ambient);
                if (mesh.is("displaced"))
                    draw_displaced(pass, scene, item, static_cast<uint32_t>(subdivide.value));
                else
                    scene.draw(pass, item);
            }
        });

        // 2. Linear light to the codes a screen expects.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(SurfaceMaps)
