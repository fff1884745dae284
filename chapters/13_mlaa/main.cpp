// Chapter 13: morphological anti-aliasing, and four other methods to compare it with.
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "13_mlaa/edge_error.h"
#include "13_mlaa/four_samples.h"
#include "13_mlaa/mlaa.h"
#include "13_mlaa/outlines.h"
#include "common/window/run.h"

using namespace lightwalk;

struct MlaaChapter : ModelChapter {
    Mlaa antialias{*this, "mlaa"};
    Outlines world{*this};
    Choice show{*this,
                "show",
                {"picture", "edges", "lengths"},
                "picture",
                "Image shown: the picture, the edges found in it, or the lengths of their lines"};

    Knob<float> walk_m_per_s{
        *this, "walk_m_per_s", 0.0f, {-50.0f, 50.0f}, "Speed at which the camera walks to its right", "m/s"};
    Knob<float> turn_deg_per_s{
        *this, "turn_deg_per_s", 0.0f, {-360.0f, 360.0f}, "Speed at which the camera turns to its left", "deg/s"};

    FourSamples four_samples{*this};
    EdgeError edge_error;
    Flicker flicker;

    MlaaChapter() {
        antialias.method.preferred = true;  // --method is about edges here
    }
    std::string default_scene() const override { return "scenes/city.json"; }

    // For the study: the error of those pixels alone through which an outline runs, and how many were mixed.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        const std::string method = antialias.method.text();
        edge_error.measure(*this, antialias, gpu, size, error);
        antialias.method.set(method);
        error["flicker"] = flicker.measure(*this, antialias, gpu, size);
    }

    // The world, seen through one sample of each pixel, or four.
    void draw_light(Frame& frame, const View& view) {
        const auto draw_from = [&](const View& from) {
            Canvas canvas(frame.hdr, frame.depth, world.background());
            if (antialias.method.is("msaa_4x") && world.has_triangles()) four_samples.multisample(frame, canvas);
            world.draw_light(frame, from, canvas);
            if (antialias.method.is("taa")) canvas.depth(frame);
        };
        world.clips = !antialias.method.is("supersample_4");
        if (world.clips) return draw_from(view);
        four_samples.supersample(frame, view, draw_from);
        world.clip_light(frame, frame.hdr);
    }

    // At time 0 it stands where the scene puts it, to the bit.
    Camera walked(float time_s) const {
        Camera moved = camera;
        const glm::vec3 ahead = camera.target - camera.position;
        const glm::vec3 right = glm::normalize(glm::cross(ahead, camera.up));
        const glm::mat4 turned =
            glm::rotate(glm::mat4(1.0f), glm::radians(turn_deg_per_s * time_s), glm::normalize(camera.up));
        moved.position += walk_m_per_s * time_s * right;
        moved.target += walk_m_per_s * time_s * right + (glm::vec3(turned * glm::vec4(ahead, 0.0f)) - ahead);
        return moved;
    }

    // [frame]
    void frame(Frame& frame) override {
        // 1. A picture in linear light, or the mean of four.
        const View view = look_at(world, frame, scene, walked(frame.time_s));
        draw_light(frame, view);

        // 2. Anti-aliasing by a filter or over frames, unless the picture was drawn with several samples.
        antialias.record(frame, frame.hdr,
                         {view, frame.depth, world.has_triangles() ? &scene : nullptr, world.drawings()});

        // 3. The edges or the lengths instead of the picture, if the knob says so.
        if (!show.is("picture")) antialias.show_edges(frame, frame.hdr, show.is("lengths"));

        // 4. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(MlaaChapter)
