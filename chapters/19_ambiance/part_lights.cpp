// Chapter 06's surfaces in a G-buffer, under chapter 03's many lights; whole, or in strips by four methods.
#include <fmt/core.h>

#include "01_obj/camera_view.h"
#include "03_attenuation/scattered_lights.h"
#include "06_deferred/deferred_scene.h"
#include "19_ambiance/part.h"

namespace lightwalk {
namespace {

struct LightsPart : FilmPart {
    LightsPart(const FilmScene& scene, Music& music) : FilmPart(scene, music) {
        objects.all_lights = [this](const Frame& frame) { return all_lights(frame); };
    }
    DeferredScene objects{*this, "objects"};
    ScatteredLights scattered{*this};
    Knob<bool> moving{*this, "moving", false, "Animation of the point and spot lights"};

    std::vector<Light> all_lights(const Frame& frame) const {
        std::vector<Light> all = scattered.all(frame.seed);
        if (moving) move_lights(all, frame.time_s);
        return all;
    }

    void draw_light(Frame& frame, const Camera& camera) override {
        const View view = look(frame, camera);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene_.file.background, 1.0f));
        draw(frame, view, canvas, {objects});
    }
};

// [street]
// The picture in upright strips of equal width, each drawn by another method as a part of the whole picture.
struct StreetPart : LightsPart {
    using LightsPart::LightsPart;

    void draw_light(Frame& frame, const Camera& camera) override {
        static const char* const methods[] = {"forward", "fat", "packed", "tiled"};
        look(frame, camera);
        for (uint32_t i = 0; i < 4; ++i) {
            objects.gbuffer.method.set(methods[i]);
            const uint32_t first = frame.size.x * i / 4, end = std::max(frame.size.x * (i + 1) / 4, first + 1);
            Crop crop = frame.crop;
            if (crop.whole == glm::uvec2(0)) crop.whole = frame.size;
            crop.origin.x += first;
            View view = view_of(camera, {end - first, frame.size.y}, crop);
            view.id = i + 1;
            Image& color = colors_[i];
            color.fit(frame.gpu.device,
                      {.name = scene().name + " strip", .format = frame.hdr.desc.format, .size = view.size});
            Image& depth = depths_[i];
            depth.fit(frame.gpu.device,
                      {.name = scene().name + " strip depth", .format = VK_FORMAT_D32_SFLOAT, .size = view.size});
            const ViewScope scope(frame, view);
            Canvas canvas(color, depth, glm::vec4(scene_.file.background, 1.0f));
            draw(frame, view, canvas, {objects});
        }
        frame.compute("strips", {.reads = {colors_[0], colors_[1], colors_[2], colors_[3]}, .writes = {frame.hdr}},
                      [&](Compute& pass) {
                          pass.use(join_);
                          for (int i = 0; i < 4; ++i) pass.set(fmt::format("strip_{}", i), colors_[i], nearest_clamp);
                          pass.set("result", frame.hdr).dispatch_threads(frame.size);
                      });
    }

  private:
    Image colors_[4], depths_[4];
    Pipeline join_ = compute({.shader = "19_ambiance/strips.comp"});
};
// [/street]

}  // namespace

std::unique_ptr<FilmPart> make_lights(const FilmScene& scene, Music& music) {
    return std::make_unique<LightsPart>(scene, music);
}

std::unique_ptr<FilmPart> make_street(const FilmScene& scene, Music& music) {
    return std::make_unique<StreetPart>(scene, music);
}

}  // namespace lightwalk
