// Shared by the tests of the air: a picture of nothing but air, and how two of them differ.
#pragma once
#include <cmath>

#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "10_atmosphere/atmosphere.h"

namespace lightwalk {

struct OnAtmosphere : OnModules {
    Atmosphere atmosphere{owner, "atmosphere"};
    Camera camera{.position = {0, 2, 0}, .target = {0, 2, -1000}, .fov_y_rad = 1.2f, .near_m = 1, .far_m = 1e9f};
    glm::uvec2 size{32, 24};

    OnAtmosphere() {
        atmosphere.orders.set("single");
        atmosphere.disc.value = 0;
    }

    void look(glm::vec3 from, glm::vec3 to, glm::vec3 up = {0, 1, 0}) {
        camera.position = from;
        camera.target = to;
        camera.up = up;
    }

    /// Of the air before black, or before a ground of that light.
    ImageRgb picture(const std::string& method, float ground = 0) {
        atmosphere.method.set(method);
        draw_frame(view_of(camera, size), atmosphere, 0, glm::vec4(glm::vec3(ground), 1));
        return read_linear(gpu, frame.hdr);
    }
};

/// Everything finite, and no channel below 0.
inline bool is_light(const ImageRgb& picture) {
    for (const glm::vec3& p : picture.pixels)
        for (int c = 0; c < 3; ++c)
            if (!std::isfinite(p[c]) || p[c] < 0) return false;
    return true;
}

struct Off {
    double mean = 0, most = 0;  ///< relative, over all pixels and channels
};

/// Where the right one is below `least` of its own brightest, nothing is asked.
inline Off relative_error(const ImageRgb& found, const ImageRgb& right, double least = 0.01) {
    double brightest = 0;
    for (const glm::vec3& p : right.pixels) brightest = std::max({brightest, double(p.r), double(p.g), double(p.b)});
    Off off;
    size_t count = 0;
    for (size_t i = 0; i < right.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double b = double(right.pixels[i][c]), e = std::fabs(double(found.pixels[i][c]) - b) / b;
            if (b < least * brightest) continue;
            off.most = std::max(off.most, e);
            off.mean += e;
            ++count;
        }
    off.mean /= double(std::max<size_t>(count, 1));
    return off;
}

inline glm::dvec3 mean(const ImageRgb& picture) {
    glm::dvec3 sum(0);
    for (const glm::vec3& p : picture.pixels) sum += glm::dvec3(p);
    return sum / double(picture.pixels.size());
}

}  // namespace lightwalk
