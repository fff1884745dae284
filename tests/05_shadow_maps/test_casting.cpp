// Shadows between drawings: what casts is found in the list that is drawn.
#include "../common/scene_fixture.h"
#include "01_obj/camera_view.h"
#include "05_shadow_maps/lit_scene.h"
#include "catch.h"

using namespace lightwalk;

namespace {

/// Casts the shadow of a square of 2 m, and is not seen itself.
struct Roof : Drawing, Caster {
    Roof(Module& owner, Gpu& gpu) : Drawing(owner, "roof") {
        SceneFile file;
        file.objects = {object_at(quad_file, {0, 0, 1})};
        square_.load(gpu, std::move(file), test_model);
    }
    void draw(Frame&, const View&, Canvas&) override {}
    Bounds bounds() const override { return square_.bounds; }
    uint64_t placed() const override { return 1; }
    std::vector<With> shadow_modules() const override { return {}; }
    void cast(Raster& pass, const View&) const override { pass.use(cast_).draw(square_); }

  private:
    Scene square_;
    Pipeline cast_ = graphics({.vertex = "05_shadow_maps/caster.vert", .cull = VK_CULL_MODE_NONE, .depth_clamp = true});
};

/// A wall of 8 m that faces +z, in light that comes straight from there.
struct OnWall : OnModules {
    LitScene objects{owner, "objects"};
    Roof roof{owner, gpu};
    Scene scene;
    const View view = view_of({.position = {0, 0, 8}, .target = {0, 0, 0}, .near_m = 0.1f, .far_m = 50.0f}, {96, 96});

    void load(std::vector<SceneObject> walls) {
        SceneFile file;
        file.objects = std::move(walls);
        file.lights = {Light{.direction = {0, 0, -1}, .shadow = true}};
        file.ambient = glm::vec3(0.0f);
        scene.load(gpu, std::move(file), test_model);
        owner.prepare_all(gpu, scene);
    }
    /// Light of the wall at a place, green.
    float seen(const Drawings& drawings, glm::vec2 at) {
        begin(view.size);
        Canvas canvas(frame.hdr, frame.depth);
        draw(frame, view, canvas, drawings);
        frame.end();
        const glm::vec4 clip = view.view_projection * glm::vec4(at, 0.0f, 1.0f);
        const glm::ivec2 pixel((glm::vec2(clip) / clip.w * 0.5f + 0.5f) * glm::vec2(view.size));
        return read_linear(gpu, frame.hdr).at(pixel.x, pixel.y).g;
    }
};

}  // namespace

TEST_CASE_METHOD(OnWall, "a drawing that casts is found in the list, in any order; its shadow ends where it ends",
                 "[casting]") {
    load({object_at(quad_file, {0, 0, 0}, glm::vec3(4.0f))});
    const float lit = seen({objects}, {0, 0});
    CHECK(lit > 0.1f);
    CHECK(seen({objects, roof}, {0, 0}) == 0);
    CHECK(seen({roof, objects}, {0.85f, -0.85f}) == 0);
    CHECK(seen({objects, roof}, {1.15f, 0}) == Approx(lit).epsilon(0.01));
    CHECK(seen({objects, roof}, {0, -1.15f}) == Approx(lit).epsilon(0.01));
    CHECK(seen({objects}, {0, 0}) == lit);  // it is gone from the list
}

TEST_CASE_METHOD(OnWall, "where nothing would be shaded there are no maps of what casts", "[casting]") {
    load({});
    seen({objects, roof}, {0, 0});
    CHECK(objects.shadow.views == 0);
}
