// Composition mistakes: each is corrected, or ends in one clear line.
#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/islands.h"
#include "common/app/render.h"

using namespace lightwalk;
using Catch::Matchers::Contains;

namespace {

struct Composed : OnModules {
    Atmosphere atmosphere{owner, "atmosphere"};
    Planet sky{owner, "sky", atmosphere};
    Mountains land{owner, "land", atmosphere, sky};
    HeightFog fog{owner, "fog"};
    Bloom bloom{owner, "bloom"};
    Post post{owner, "post"};
    Scene scene;
    const glm::uvec2 size{48, 32};

    Composed() {
        sky.map.set("plain");
        atmosphere.table_scale.value = 0.25f;
        scene.load(gpu, {.objects = {{.name = "hill", .parent = {}, .model = "models/cube.obj"}}},
                   [](const std::filesystem::path& file) { return load_model(file, Loader::parallel); });
        owner.prepare_all(gpu, scene);
    }
    View view() const {
        return view_of({.position = {0, 2, 6}, .target = {0, 1, 0}, .near_m = 0.1f, .far_m = 1e5f}, size);
    }
    /// One draw() for each list.
    ImageRgb picture(const std::vector<Drawings>& lists) {
        begin(size);
        Canvas canvas(frame.hdr, frame.depth);
        for (const Drawings& drawings : lists) try {
                draw(frame, view(), canvas, drawings);
            } catch (...) {
                frame.end();
                throw;
            }
        frame.end();
        return read_linear(gpu, frame.hdr);
    }
    /// In a frame that shows the land under its sky.
    template <class Finish>
    void finish(const Finish& record) {
        begin(size);
        Canvas canvas(frame.hdr, frame.depth);
        draw(frame, view(), canvas, {land, sky, atmosphere});
        try {
            record();
        } catch (...) {
            frame.end();
            throw;
        }
        frame.end();
    }
};

/// A frame that shows nothing.
struct Forgetful : Chapter {
    bool encodes = true;
    Forgetful() { name = "99_forgetful"; }
    std::string default_scene() const override { return ""; }
    Model load_model(const std::filesystem::path&) override { return {}; }
    void frame(Frame& frame) override {
        frame.raster("fill", {.color = {clear(frame.hdr, glm::vec4(0.5f))}}, [](Raster&) {});
        if (encodes) encode_srgb(frame);
    }
};

bool same(const ImageRgb& a, const ImageRgb& b) { return a.pixels == b.pixels; }

}  // namespace

TEST_CASE_METHOD(Composed, "no sun given: the drawing that has one gives it, and none is drawn without it",
                 "[mistakes]") {
    picture({{land, sky, atmosphere}});
    CHECK(scene.sun().to_sun == atmosphere.sun().to_sun);
    CHECK(scene.sun().light == atmosphere.sun().light);
    CHECK_THROWS_WITH(picture({{land, sky}}),
                      Contains("'land' is lit by 'atmosphere', which this frame does not draw"));
}

TEST_CASE_METHOD(Composed, "sky before land: one list is put in order, a second list is refused", "[mistakes]") {
    const ImageRgb right = picture({{land, sky, atmosphere}});
    CHECK(same(picture({{atmosphere, sky, land}}), right));
    CHECK_THROWS_WITH(picture({{sky, atmosphere}, {land}}),
                      Contains("'land' (opaque) is drawn after 'atmosphere' (air)"));
}

TEST_CASE_METHOD(Composed, "fog first: one list is put in order, a second list is refused", "[mistakes]") {
    fog.density.value = 0.05f;
    const ImageRgb right = picture({{land, sky, atmosphere, fog}});
    CHECK(same(picture({{fog, land, sky, atmosphere}}), right));
    CHECK_THROWS_WITH(picture({{fog}, {land, sky, atmosphere}}), Contains("is drawn after 'fog' (fog)"));
}

TEST_CASE_METHOD(Composed, "bloom after tones is refused", "[mistakes]") {
    CHECK_NOTHROW(finish([&] {
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
    }));
    CHECK_THROWS_WITH(finish([&] {
                          post.record(frame, frame.hdr);
                          bloom.record(frame, frame.hdr);
                      }),
                      Contains("bloom needs linear light") && Contains("record it before the tones"));
}

TEST_CASE_METHOD(Composed, "tones twice are refused", "[mistakes]") {
    Post second{owner, "second"};
    const auto both = [&] {
        post.record(frame, frame.hdr);
        second.record(frame, frame.hdr);
    };
    CHECK_THROWS_WITH(finish(both), Contains("second applies a tone curve") && Contains("keep one of the two"));
    CHECK_THROWS_WITH(finish([&] {
                          post.record(frame, frame.hdr);
                          encode_film(frame);
                      }),
                      Contains("encode_film"));
    second.tone.set("off");  // grain alone, say
    CHECK_NOTHROW(finish(both));
}

TEST_CASE_METHOD(DeviceTest, "a frame that writes no output is refused", "[mistakes]") {
    Forgetful chapter;
    CHECK_NOTHROW(render(chapter, frame, {{8, 8}, 0, 0, {}}));
    chapter.encodes = false;
    CHECK_THROWS_WITH(render(chapter, frame, {{8, 8}, 0, 0, {}}), Contains("99_forgetful wrote no output"));
}
