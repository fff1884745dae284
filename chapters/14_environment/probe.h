// A light probe: surroundings that are drawn from a place in the scene, as a module.
#pragma once
#include <glm/gtc/constants.hpp>

#include "14_environment/image_light.h"
#include "common/app/world.h"
#include "common/base/epoch.h"

namespace lightwalk {

/// Draws six views of a list of drawings into light.drawn, filters it in the same frame, and binds it for shaders.
/// In a frame, after light.record():
///
///     probe.record(frame, scene, light, {objects});
struct SceneProbe : Module {
    SceneProbe(Module& owner, std::string name);

    Choice update{*this,
                  "update",
                  {"off", "moved", "always", "face"},
                  "off",
                  "When the probe is drawn: never (the scene's environment is used), in a frame in which something has "
                  "moved, in each frame, or one of its six faces in each frame"};
    Knob<glm::vec3> center{
        *this, "center", glm::vec3(0, 1, 0), {glm::vec3(-1e4f), glm::vec3(1e4f)}, "Place that the probe is drawn from",
        "m"};
    Knob<bool> box{*this, "box", true, "Lookups corrected for a box around the probe (parallax)"};
    Knob<glm::vec3> lower{
        *this, "lower", glm::vec3(-5, 0, -5), {glm::vec3(-1e4f), glm::vec3(1e4f)}, "Lower corner of that box", "m"};
    Knob<glm::vec3> upper{*this, "upper", glm::vec3(5), {glm::vec3(-1e4f), glm::vec3(1e4f)}, "Upper corner of that box",
                          "m"};
    bool distant = false;  ///< only the sky is drawn, infinitely far away, so there is no box
    Knob<float> near_m{*this, "near_m", 0.05f, {1e-4f, 100.0f}, "Near plane of the six views", "m"};

    void record(Frame& frame, const Scene& scene, ImageLight& light, const Drawings& drawings);
    void record(Frame& frame, const Scene& scene, ImageLight& light, World& world);
    void prepare(Gpu&, Scene&) override {
        made_.forget();
        next_face_ = 0;
    }

    int drawn_faces = 0;                               ///< of the last frame
    const Image& last_face() const { return color_; }  ///< mirrored from left to right

  private:
    DerivedViews views_;
    using Draw = std::function<void(const View& view, Canvas& canvas)>;
    void record(Frame& frame, const Scene& scene, ImageLight& light, const std::vector<const Module*>& dependencies,
                const Draw& draw);
    void draw_face(Frame& frame, const Scene& scene, LightCubes& cubes, uint32_t face, const Draw& draw);
    Image color_, depth_;
    Fingerprint made_;
    uint32_t next_face_ = 0;
    Pipeline to_face_ = compute({.shader = "14_environment/probe_face.comp"});
};

/// The camera of a cube's face, mirrored from left to right; its picture is square.
Camera face_camera(uint32_t face, glm::vec3 center, float near_m, float far_m);

}  // namespace lightwalk
