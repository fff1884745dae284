// Shared by the tests of temporal anti-aliasing: frames of a world of flat layers, and the method's result.
#pragma once
#include "01_obj/camera_view.h"
#include "mlaa_fixture.h"

namespace lightwalk {

/// A world in the plane of the picture: positions in pixels, (0, 0) its upper left corner.
struct Sample {
    glm::vec3 light{0.0f};
    float depth = 0;
};

struct OnTaa : OnModules {
    Mlaa by{owner, "mlaa"};
    Taa& taa = by.taa;
    Camera camera;
    Scene* scene = nullptr;
    Drawings drawings;  ///< none: the method cannot know whether the world has changed
    Image picture, depth;
    int drawn = 0;

    OnTaa() { by.method.set("taa"); }

    /// One frame of world(x, y), each pixel sampled where its shift says.
    template <class World>
    ImageRgb draw(glm::uvec2 size, const World& world) {
        const glm::vec2 shift = taa.accumulation().shift(drawn++);
        const View view = view_of(camera, size, {.whole = size, .shift = shift});
        std::vector<float> depths;
        const auto at = [&](int x, int y) { return world(float(x) + 0.5f + shift.x, float(y) + 0.5f + shift.y); };
        for (uint32_t y = 0; y < size.y; ++y)
            for (uint32_t x = 0; x < size.x; ++x) depths.push_back(at(int(x), int(y)).depth);
        depth.ensure(gpu.device, {.name = "depth", .format = VK_FORMAT_R32_SFLOAT, .size = size});
        const auto light = [&](int x, int y) { return at(x, y).light; };
        filter_frame(picture, size, half_texels(size, light, 0.25f), [&] {
            frame.upload("depth", depth, std::as_bytes(std::span(depths)));
            by.record(frame, picture, {view, depth, scene, drawings});
        });
        return read_linear(gpu, picture);
    }
    template <class World>
    ImageRgb draw_many(int frames, glm::uvec2 size, const World& world) {
        owner.forget_history();
        drawn = 0;
        ImageRgb last;
        for (int i = 0; i < frames; ++i) last = draw(size, [&](float x, float y) { return world(x, y, i); });
        return last;
    }
};

/// Root of the mean squared error against the exact coverage of a half-plane, over the pixels through which it runs.
inline double rest_error(const ImageRgb& found, const Line& line) { return edge_error(found, line, 2); }

}  // namespace lightwalk
