// Chapter 12: skin. Light enters it at one place and leaves it at another.
#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "01_obj/model_chapter.h"
#include "05_shadow_maps/shadow.h"
#include "11_fractals/environment.h"
#include "12_skin/skin.h"
#include "common/window/run.h"

using namespace lightwalk;

struct SkinChapter : ModelChapter {
    Skin skin{*this, "skin"};
    Maps maps{*this, "maps"};
    Lights lights{*this, "lights"};
    Shadow shadow{*this, "shadow"};
    Rays rays{*this, "rays"};
    EnvironmentLight environment{*this, "environment"};
    Knob<float> backdrop{
        *this, "backdrop", 4.5f, {0.0f, 8.0f}, "which level of the environment is seen behind: more is blurrier"};
    Choice show{
        *this,
        "show",
        {"picture", "irradiance", "level", "diffused", "stretch", "occlusion", "thickness", "specular", "seams"},
        "picture",
        "or one of the skin's maps, or what is reflected alone, or what comes through, or the charts"};
    Knob<int> level{*this, "level", 0, {0, 5}, "which Gaussian's, of show level"};
    Knob<float> dolly{*this, "dolly", 1.0f, {0.2f, 64.0f}, "how many times as far away the camera stands"};
    Pipeline behind = compute({.shader = "12_skin/backdrop.comp"});
    Pipeline look = compute({.shader = "12_skin/look.comp"});

    SkinChapter() {
        skin.method.alone = true;  // --method is about skin here
        maps.method.change_default("normal");
        lights.method.change_default("every_light");
    }
    std::string default_scene() const override { return "scenes/portrait.json"; }
    std::string load_key() const override { return maps.load_key(); }
    void prepare(Gpu& gpu) override {
        maps.prepare(gpu, scene);
        skin.prepare(gpu, scene);
        rays.prepare(gpu, scene);
        shadow.forget();
    }

    // For the study: how wide the widest Gaussian is on the screen, in pixels.
    void measure(Gpu&, glm::uvec2 size, nlohmann::json& error) override {
        error["widest_px"] = skin.widest_px(dolly * glm::length(camera.position - camera.target), camera, size.y);
    }

    // One of the skin's maps in place of the picture.
    void look_at(Frame& frame, const Image& image, glm::vec3 gain) {
        frame.compute("look", {.reads = {image}, .writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(look).set("image", image, nearest_clamp).set("gain", gain).set("result", frame.hdr);
            pass.dispatch_threads(frame.size);
        });
    }

    void look_at_maps(Frame& frame) {
        if (show.is("stretch")) look_at(frame, skin.layout().stretch, {0.2f, 0.2f, 0.0f});
        if (show.is("occlusion")) look_at(frame, skin.occlusion(), glm::vec3(1));
        if (skin.on_map() && show.is("irradiance")) look_at(frame, skin.irradiance(), glm::vec3(1));
        if (skin.on_map() && show.is("diffused")) look_at(frame, skin.diffused(), glm::vec3(1));
        if (skin.sum_count() && show.is("level")) look_at(frame, skin.level(size_t(level)), glm::vec3(1));
    }

    // [frame]
    void frame(Frame& frame) override {
        const glm::vec3 near = std::exchange(camera.position, glm::mix(camera.target, camera.position, dolly.value));
        set_view(frame);

        // 1. The lights, and depth from those that cast shadows.
        lights.update(frame, scene, scene.file.lights);
        lights.record(frame, scene, camera);
        shadow.record(frame, scene, lights, camera);
        rays.record(frame, scene);
        environment.record(frame, scene);
        const Skin::Lit lit{maps, rays, {lights, shadow, environment}};

        // 2. The light on the skin's map, and how it spreads there.
        skin.record(frame, scene, camera, lit);

        // 3. The picture.
        frame.compute("backdrop", {.writes = {frame.hdr}, .with = {environment}}, [&](Compute& pass) {
            pass.use(behind).set("backdrop", backdrop.value).set("result", frame.hdr).dispatch_threads(frame.size);
        });
        skin.draw(frame, scene, lit,
                  show.is("specular")    ? Skin::Shown::specular
                  : show.is("thickness") ? Skin::Shown::thickness
                  : show.is("seams")     ? Skin::Shown::seams
                                         : Skin::Shown::all);
        skin.finish(frame, camera);
        camera.position = near;
        if (!skin.empty()) look_at_maps(frame);

        // 4. Linear light to the codes a screen expects.
        encode_srgb(frame);
    }
    // [/frame]

    std::vector<std::string> status() const override {
        if (!skin.on_map() || skin.empty()) return {};
        return {fmt::format("the map of light is {} texels wide", skin.irradiance().desc.size.x)};
    }
};

CHAPTER(SkinChapter)
