// Parts of a chapter, as docs/framework.md shows them; compiled with glass_valley.cpp.
#include "01_obj/model_chapter.h"
#include "06_deferred/gbuffer.h"
#include "08_bloom/bloom.h"
#include "11_fractals/terrain.h"
#include "15_terrain_water/water.h"

using namespace lightwalk;

namespace {

// [kind]
struct Glow : Module {
    Glow(Module& owner, std::string name) : Module(owner, std::move(name), "glow") {}
    Knob<float> strength{*this, "strength", 1.0f, {0, 4}, "Strength of the glow"};
};
// [/kind]

struct Parts : ModelChapter {
    // [kind_used]
    Glow sun{*this, "sun"}, moon{*this, "moon"};  // options sun.strength and moon.strength, one block `glow`
    // [/kind_used]
    Choice background{*this, "background", {"none", "hills"}, "none", "What stands behind the objects"};
    Terrain terrain{*this, "terrain"};
    Bloom bloom{*this, "bloom"};
    GBuffer gbuffer{*this, "gbuffer"};
    Mirror mirror{*this, "mirror"};
    Pipeline light = compute({.shader = "06_deferred/light.comp"});

    Parts() {
        // [preferred]
        bloom.method.preferred = true;  // --set method=exact means bloom.method; gbuffer.method needs its whole path
        // [/preferred]
        // [in_use]
        terrain.in_use = [this] { return background.is("hills"); };  // otherwise neither prepared nor drawn
        // [/in_use]
    }

    void deferred(Frame& frame, const View& view, const std::function<void(Raster&)>& draw_surfaces) {
        // [gbuffer]
        gbuffer.begin(frame, view, frame.depth);
        frame.raster("surfaces", {.color = gbuffer.targets(), .depth = clear(frame.depth, 0.0f), .with = {gbuffer}},
                     draw_surfaces);
        gbuffer.written();
        frame.compute("light", {.reads = {frame.depth}, .writes = {frame.hdr}, .with = {gbuffer}},
                      [&](Compute& pass) { pass.use(light).set("hdr", frame.hdr).dispatch_threads(frame.size); });
        // [/gbuffer]
    }

    void reflect(Frame& frame, const View& view, Drawing& objects, const Pipeline& floor) {
        // [mirror]
        mirror.record(frame, view, 0.0f, {objects});  // everything above the plane y = 0, seen from below
        frame.raster("floor", {.color = {keep(frame.hdr)}, .depth = keep(frame.depth), .reads = {mirror.image()}},
                     [&](Raster& pass) { pass.use(floor).set("reflected", mirror.image()).draw(6); });
        // [/mirror]
    }
};

}  // namespace
