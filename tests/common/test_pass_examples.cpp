// The passes that docs/framework.md shows.
#include <limits>

#include "common/app/target.h"
#include "tests/common/module_fixture.h"
#include "tests/common/shaders/tint.h"

using namespace lightwalk;

namespace {

// [tint_module]
struct Tint : Module {
    using Module::Module;
    Knob<float> strength{*this, "strength", 1.0f, {0, 1}, "Share of the tinted light"};
    Choice method{*this, "method", {"multiply", "mix"}, "multiply", "How light and colour are combined"};

    void record(Frame& frame, const Image& picture) {
        frame.compute("tint", {.reads = {picture}, .writes = {result}, .with = {*this}}, [&](Compute& pass) {
            pass.use(pipeline_).set("from", picture, nearest_clamp).set("into", result);
            pass.set("pigment", Pigment{.color = {4.0f, 2.0f, 0.0f}, .share = 0.25f}).dispatch_threads(frame.size);
        });
    }
    Target result{*this, {.name = "result"}};  // RGBA16F, of the frame's size

  private:
    Pipeline pipeline_ = compute({.shader = "../tests/common/shaders/tint.comp"});
};
// [/tint_module]

const Pipeline darken = compute({.shader = "../tests/common/shaders/darken.comp"});
const Pipeline heights = compute({.shader = "../tests/common/shaders/height.comp"});

}  // namespace

TEST_CASE_METHOD(OnModules, "the passes of framework.md compute what it says", "[framework]") {
    Tint tint{owner, "tint"};
    const auto draw = [&](const char* method, float strength) {
        tint.method.set(method);
        tint.strength.value = strength;
        begin({4, 4});
        frame.raster("light", {.color = {clear(frame.hdr, glm::vec4(2, 2, 2, 1))}}, [](Raster&) {});
        tint.record(frame, frame.hdr);
        // [in_place]
        frame.compute("darken", {.reads = {frame.hdr}, .writes = {frame.hdr}},
                      [&](Compute& pass) { pass.use(darken).set("picture", frame.hdr).dispatch_threads(frame.size); });
        // [/in_place]
        frame.end();
        return std::pair(glm::vec4(glm::unpackHalf4x16(read<uint64_t>(tint.result)[5])),
                         glm::vec4(glm::unpackHalf4x16(read<uint64_t>(frame.hdr)[5])));
    };
    CHECK(draw("multiply", 1.0f) == std::pair(glm::vec4(8, 4, 0, 1), glm::vec4(1, 1, 1, 1)));
    CHECK(draw("multiply", 0.5f).first == glm::vec4(5, 3, 1, 1));
    CHECK(draw("mix", 1.0f).first == glm::vec4(2.5f, 2, 1.5f, 1));
}

TEST_CASE_METHOD(OnModules, "a pixel's position follows from its depth as framework.md says", "[framework]") {
    Target result{owner, {.name = "result"}};
    View view;
    view.camera = {.position = {0, 5, 0},
                   .target = {0, 5, -1},
                   .fov_y_rad = glm::radians(90.0f),
                   .near_m = 1.0f,
                   .far_m = std::numeric_limits<float>::infinity()};
    view.crop.whole = {4, 4};
    begin({4, 4});
    frame.raster("depth", {.depth = clear(frame.depth, 0.25f)}, [](Raster&) {});  // 4 m along the view
    // [position]
    frame.compute("height", {.reads = {frame.depth}, .writes = {result}}, [&](Compute& pass) {
        pass.use(heights).set("depth", frame.depth, nearest_clamp).set("rays", view_rays(view));
        pass.set("into", result).dispatch_threads(frame.size);
    });
    // [/position]
    frame.end();
    const std::vector<uint64_t> texels = read<uint64_t>(result);
    const auto height = [&](size_t row) { return glm::unpackHalf4x16(texels[4 * row]).x; };
    CHECK(height(0) == Approx(8));
    CHECK(height(1) == Approx(6));
    CHECK(height(3) == Approx(2));
}
