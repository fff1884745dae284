// Chapter 10: a planet's air, from the ground to orbit.
#include "01_obj/model_chapter.h"
#include "10_atmosphere/atmosphere.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "10_atmosphere/preetham.h"
#include "common/window/run.h"

using namespace lightwalk;

struct AtmosphereChapter : ModelChapter {
    Atmosphere atmosphere{*this, "atmosphere"};
    Planet planet{*this, "planet"};
    HeightFog fog{*this, "fog"};

    Choice show{*this,
                "show",
                {"picture", "transmittance", "multiple", "sky", "doubt"},
                "picture",
                "or a table of the method tables; doubt: the standard error of truth, relative"};
    Knob<float> gain{*this, "gain", 1.0f, {0.0f, 1e6f}, "by what a table is multiplied to be shown"};

    Pipeline surface = graphics({.vertex = "01_obj/mesh.vert", .fragment = "10_atmosphere/surface.frag"});
    Pipeline look = compute({.shader = "08_bloom/look.comp"});
    Pipeline tone = compute({.shader = "10_atmosphere/tone.comp"});

    AtmosphereChapter() {
        atmosphere.method.alone = true;  // --method is about the air here
        fog.method.change_default("none");
    }
    std::string default_scene() const override { return "scenes/islands.json"; }
    std::string load_key() const override { return planet.map.text(); }
    void prepare(Gpu& gpu) override { planet.prepare(gpu); }

    // One of the air's tables in place of the picture.
    void look_at(Frame& frame, const Image& image) {
        frame.compute("look", {.reads = {image}, .writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(look).set("image", image, nearest_clamp).set("gain", gain.value).set("result", frame.hdr);
            pass.dispatch_threads(frame.size);
        });
    }

    // [frame]
    void frame(Frame& frame) override {
        // 1. What is solid, as if there were no air before it: mountains, then the planet and what lies beyond it.
        set_view(frame);
        atmosphere.light_ground(frame);
        frame.raster("mountains", {.color = {frame.hdr}, .depth = frame.depth, .with = {atmosphere, planet}},
                     [&](Raster& pass) { pass.use(surface).draw(scene); });
        planet.record(frame, atmosphere, camera);

        // 2. The air before it.
        atmosphere.record(frame, frame.hdr, frame.depth, camera);
        fog.record(frame, frame.hdr, frame.depth, camera, atmosphere.to_sun());

        if (atmosphere.method.is("tables") && show.index > 0 && show.index < 4)
            look_at(frame, show.is("sky")        ? atmosphere.sky()
                           : show.is("multiple") ? atmosphere.multiple()
                                                 : atmosphere.transmittance());
        if (atmosphere.method.is("truth") && show.is("doubt")) look_at(frame, atmosphere.doubt());

        // 3. Linear light to the codes a screen expects; what is brighter than white fades into it.
        accumulate(frame);
        frame.compute("tone", {.reads = {frame.linear()}, .writes = {frame.output}}, [&](Compute& pass) {
            pass.use(tone).set("hdr", frame.linear(), nearest_clamp).set("result", frame.output);
            pass.dispatch_threads(frame.size);
        });
    }
    // [/frame]
};

CHAPTER(AtmosphereChapter)
