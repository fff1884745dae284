// Shared by the tests of water: water before a background, and a wall that it shows.
#pragma once
#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "15_terrain_water/water.h"
#include "15_terrain_water/water_truth.h"
#include "common/check/probe.h"

namespace lightwalk {

struct OnWater : OnModules {
    ImageLight light{owner, "environment"};
    Water water{owner, "water", light};
    Scene scene;
    Camera camera{.position = {0, 5, 0}, .target = {0, 4, -20}, .fov_y_rad = 0.8f, .near_m = 0.1f, .far_m = 1e5f};
    glm::uvec2 size{96, 64};
    glm::vec4 background{0.3f, 0.5f, 0.8f, 1};

    OnWater() {
        light.radiance_alone = true;  // as Shore has it
        scene.set_sun({.to_sun = glm::normalize(glm::vec3(0.3f, 0.5f, -0.6f)),
                       .light = glm::vec3(3.0f),
                       .sky = {0.2f, 0.3f, 0.5f}});
        owner.prepare_all(gpu, scene);
    }

    ImageRgb picture(const std::string& method, const std::string& reflection, float time_s = 0,
                     const Drawings& solid = {}) {
        water.method.set(method);
        water.reflection.set(reflection);
        begin(size, time_s);
        const View view = view_of(camera, size);
        light.record(frame, scene);
        Drawings all = solid;
        all.push_back(water);
        water.reflect(frame, view, all);
        Canvas canvas(frame.hdr, frame.depth, background);
        lightwalk::draw(frame, view, canvas, all);
        frame.end();
        return read_linear(gpu, frame.hdr);
    }
};

inline bool all_finite(const ImageRgb& picture) {
    for (const glm::vec3& p : picture.pixels)
        if (!std::isfinite(p.r + p.g + p.b) || p.r < 0 || p.g < 0 || p.b < 0) return false;
    return true;
}

// A bright vertical wall.
struct Wall : Drawing {
    explicit Wall(Module& owner) : Drawing(owner, "wall") {}
    glm::vec4 color{4, 0, 0, 1};
    float left = -8, right = 1, bottom = -3, top = 6, z = -40;
    void draw(Frame& frame, const View&, Canvas& canvas) override {
        frame.raster("wall", {.color = {canvas.color_target()}, .depth = canvas.depth_target()}, [&](Raster& pass) {
            struct {
                glm::vec3 corners[4];
                glm::vec4 color;
            } quad{{{left, bottom, z}, {right, bottom, z}, {right, top, z}, {left, top, z}}, color};
            pass.use(pipeline).set("quad", quad).draw(6);
        });
    }
    Pipeline pipeline = graphics({.vertex = "../tests/15_terrain_water/wall.vert",
                                  .fragment = "../tests/15_terrain_water/wall.frag",
                                  .cull = VK_CULL_MODE_BACK_BIT});
};

}  // namespace lightwalk
