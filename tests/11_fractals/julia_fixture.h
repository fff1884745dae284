// Shared by the tests of Julia sets: the module on a device, without a picture around it.
#pragma once
#include <cmath>

#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "11_fractals/julia.h"
#include "11_fractals/truth.h"
#include "common/check/probe.h"

namespace lightwalk {

struct OnJulia : OnModules {
    EnvironmentLight environment{owner, "environment"};
    Julia julia{owner, "julia", environment};
    Scene scene;
    Camera camera{.position = {0.9f, 0.55f, 2.9f}, .fov_y_rad = 0.73f};
    glm::uvec2 size{96, 54};

    OnJulia() {
        scene.file.ambient = glm::vec3(0.5f);
        julia.prepare(gpu, scene);
    }

    void draw(float time_s = 0) { draw_frame(view_of(camera, size), julia, time_s); }

    /// Of each pixel: metres, distances asked for, how it ended.
    std::vector<glm::vec4> marched() { return read<glm::vec4>(julia.found); }

    ImageRgb picture() { return read_linear(gpu, frame.hdr); }

    glm::dvec3 direction(size_t pixel) const {
        const ViewRays rays = view_rays(view_of(camera, size));
        return glm::normalize(glm::dvec3(rays.corner) + (double(pixel % size.x) + 0.5) * glm::dvec3(rays.right) +
                              (double(pixel / size.x) + 0.5) * glm::dvec3(rays.down));
    }

    /// The truth's depth of a pixel, or -1.
    double depth(size_t pixel) const {
        const truth::JuliaRay ray{.c = glm::dvec4(julia.constant_at(0)), .slice = double(julia.slice)};
        const glm::dvec3 from(camera.position), along = direction(pixel);
        const glm::dvec2 range = truth::within_ball(from, along, double(julia_bound(glm::vec4(ray.c))));
        return range.x < range.y ? truth::julia_depth(ray, from, along, range.x, range.y) : -1;
    }

    double mean_steps() {
        double sum = 0;
        const auto all = marched();
        for (const glm::vec4& one : all) sum += double(one.y);
        return sum / double(all.size());
    }
};

}  // namespace lightwalk
