// Shared by the tests of planets: the modules on a device, a body and a camera.
#pragma once
#include <cmath>

#include "../common/gpu_fixture.h"
#include "01_obj/camera_view.h"
#include "17_planets/solar_system.h"
#include "17_planets/truth.h"
#include "common/app/read_picture.h"
#include "common/check/probe.h"

namespace lightwalk {

struct OnPlanets {
    struct Owner : Module {
    } owner;
    Planets planets;
    Stars stars{owner, "stars", planets};
    Flight flight{owner, "flight", planets};
    Scene scene;
    Camera camera{.fov_y_rad = 0.45f};
    std::optional<glm::dvec3> exact_eye;
    Gpu& gpu = validated_device();
    Frame frame{gpu};
    glm::uvec2 size{96, 64};
    bool with_stars = false, with_planets = true;
    Crop crop{};     ///< which part of a larger picture is drawn
    float wall = 0;  ///< reversed depth of an object before every body; 0: none

    explicit OnPlanets(std::string name = "planets") : planets(owner, std::move(name)) {}
    ~OnPlanets() { CHECK_NOTHROW(gpu.device.check_validation()); }

    /// The body from that many of its radii away, at a phase angle, from `up_deg` above the plane of its orbit.
    void look_at(const char* body, double radii, double phase_deg = 30, double up_deg = 0) {
        planets.at.set(body);
        if (std::string state = owner.load_state(); state != loaded_) {  // maps take longer than a small picture
            owner.prepare_all(gpu, scene);
            loaded_ = std::move(state);
        }
        const double r = traits(static_cast<BodyId>(planets.at.index)).radius_m;
        const double a = glm::radians(phase_deg), u = glm::radians(up_deg);
        camera.position =
            glm::vec3(radii * r * glm::dvec3(std::cos(u) * std::sin(a), std::sin(u), std::cos(u) * std::cos(a)));
        camera.target = glm::vec3(0.0f);
    }

    ImageRgb picture(float time_s = 0, glm::vec2 shift = glm::vec2(0.0f)) {
        owner.begin_frame(gpu, size);
        frame.begin(size, time_s);
        Canvas canvas(frame.hdr, frame.depth);
        Crop part = crop;
        if (part.whole.x == 0) part.whole = size;
        part.shift = shift;
        View view = view_of(camera, size, part);
        view.exact_eye = exact_eye;
        if (wall > 0) {
            canvas.depth_overwritten();
            frame.raster("wall", {.depth = clear(frame.depth, wall)}, [](Raster&) {});
        }
        Drawings drawn;
        if (with_stars) drawn.push_back(stars);
        if (with_planets) drawn.push_back(planets);
        lightwalk::draw(frame, view, canvas, drawn);
        if (!canvas.has_color()) canvas.color(frame);
        frame.end();
        return read_linear(gpu, frame.hdr);
    }

  private:
    std::string loaded_;  ///< the load state that was prepared last
};

inline double sum_of(const ImageRgb& picture) {
    double sum = 0;
    for (const glm::vec3& pixel : picture.pixels) sum += static_cast<double>(pixel.g);
    return sum;
}

inline bool is_finite(const ImageRgb& picture) {
    for (const glm::vec3& pixel : picture.pixels)
        if (!all_finite(pixel)) return false;
    return true;
}

}  // namespace lightwalk
