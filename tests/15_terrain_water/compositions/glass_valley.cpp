// The chapter of docs/framework.md: glass over a landscape under a sky, with fog, bloom, anti-aliasing and tones.
// [chapter]
#include "01_obj/model_chapter.h"
#include "05_shadow_maps/lit_scene.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "11_fractals/terrain.h"
#include "13_mlaa/mlaa.h"
#include "15_terrain_water/transparency.h"
#include "common/window/run.h"

using namespace lightwalk;

struct GlassValley : ModelChapter {
    Atmosphere atmosphere{*this, "atmosphere"};
    Planet sky{*this, "sky", atmosphere};
    Terrain terrain{*this, "terrain"};
    LitScene objects{*this, "objects"};
    Transparency glass{*this, "glass"};
    HeightFog fog{*this, "fog"};
    Bloom bloom{*this, "bloom"};
    Mlaa antialias{*this, "antialias"};
    Post post{*this, "post"};

    GlassValley() { terrain.own_sky = false; }
    std::string default_scene() const override { return "scenes/islands.json"; }

    void frame(Frame& frame) override {
        const View view = set_view(frame);

        // By phase: opaque surfaces, the sky behind them, the air and the fog; transparent surfaces last.
        Canvas canvas(frame.hdr, frame.depth);
        canvas.blended_by(&glass);
        draw(frame, view, canvas, {terrain, objects, sky, atmosphere, fog});

        // Linear light: bloom, then edges; then tones, and sRGB.
        bloom.record(frame, frame.hdr);
        antialias.record(frame, frame.hdr, {view, frame.depth, &scene});
        post.record(frame, frame.hdr);
        encode_srgb(frame);
    }
};

CHAPTER(GlassValley)
// [/chapter]
