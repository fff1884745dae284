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

    Pipeline surface = graphics({.vertex = "01_obj/mesh.vert", .fragment = "10_atmosphere/surface.frag"});
    Pipeline tone = compute({.shader = "10_atmosphere/tone.comp"});

    AtmosphereChapter() {
        atmosphere.method.alone = true;  // --method is about the air here
        fog.method.change_default("none");
    }
    std::string default_scene() const override { return "scenes/sunset_islands.json"; }
    std::string load_key() const override { return planet.map.text(); }
    void prepare(Gpu& gpu) override { planet.prepare(gpu); }

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
