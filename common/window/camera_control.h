// Moves a camera: around its target, with the picture, towards the target, or freely.
#pragma once
#include <optional>

#include "common/app/chapter.h"
#include "common/scene/camera.h"
#include "common/scene/mesh.h"

namespace lightwalk {

class Activity;
class Display;
struct Input;

/// Angles and fractions come from the caller, lengths from the scene: a step is a fraction of the viewing distance.
class CameraControl {
  public:
    /// Turns around the target, keeping the horizon level: `turn_rad` about +y, `tilt_rad` up and down to the poles.
    static void orbit(Camera& camera, float turn_rad, float tilt_rad);

    /// Moves with the picture: `pixels` of a picture `height` pixels high, y down, so that the target's plane follows.
    static void pan(Camera& camera, glm::vec2 pixels, float height);

    /// Halves the distance to the target in about seven notches. Stops short of the target and of `bounds` far away.
    static void zoom(Camera& camera, float notches, const Bounds& bounds);

    /// Looks around from where the camera stands.
    static void look(Camera& camera, float turn_rad, float tilt_rad);

    /// Moves eye and target by metres along the camera's right, up and forward.
    static void fly(Camera& camera, glm::vec3 metres);

    /// Keeps the direction of view and steps back until all of `bounds` is in the picture.
    static void frame(Camera& camera, const Bounds& bounds, float aspect);

    /// Lifts an eye that is below the given height, in metres; its target stays.
    static void stay_above(Camera& camera, const std::optional<float>& lowest_m);

    /// A fifth of the scene a second, in metres.
    static float fly_speed(const Bounds& bounds);
};

/// A drag that begins over the panel stays with it; one over the picture goes to the camera, or to the chapter's own
/// tool.
class CameraMouse {
  public:
    CameraMouse(Chapter& chapter, Display& display, Activity& activity)
        : chapter_(chapter), display_(display), activity_(activity) {}

    /// `cursor_px`: from the corner of the picture, which has the size `picture`, in pixels. `seconds` since the last call,
    /// for keys that fly.
    void move(const Input& input, glm::vec2 cursor_px, glm::uvec2 picture, double seconds);

  private:
    bool tool_has_mouse(const Input& input, glm::vec2 cursor, glm::uvec2 picture);
    void follow_mouse(glm::vec2 place);
    void drag(const Input& input);
    void fly(const Input& input, double seconds);
    Chapter& chapter_;
    Display& display_;
    Activity& activity_;
    bool dragging_ = false;
};

}  // namespace lightwalk
