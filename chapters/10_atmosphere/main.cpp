// Chapter 10: the atmosphere of a planet, from the ground to orbit.
#include "01_obj/model_chapter.h"
#include "09_post_effects/encode_film.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/mountains.h"
#include "10_atmosphere/preetham.h"
#include "common/window/run.h"

using namespace lightwalk;

struct AtmosphereChapter : ModelChapter {
    Atmosphere atmosphere{*this, "atmosphere"};
    Planet planet{*this, "planet", atmosphere};
    Mountains mountains{*this, "mountains", atmosphere, planet};
    HeightFog fog{*this, "fog"};

    Choice show{*this,
                "show",
                {"picture", "transmittance", "multiple", "sky", "doubt"},
                "picture",
                "Image shown: the picture; a table of the method tables; or the relative standard error of the "
                "path-traced reference"};
    Knob<float> gain{*this, "gain", 1.0f, {0.0f, 1e6f}, "Scale factor for the brightness of a displayed table"};

    Pipeline look = compute({.shader = "08_bloom/look.comp"});

    AtmosphereChapter() {
        atmosphere.method.alone = true;  // --method is about the air here
        fog.method.change_default("none");
    }
    std::string default_scene() const override { return "scenes/islands.json"; }

    // One of the air's tables in place of the picture.
    void look_at(Frame& frame, const Image& image) {
        frame.compute("look", {.reads = {image}, .writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(look).set("image", image, nearest_clamp).set("gain", gain.value).set("result", frame.hdr);
            pass.dispatch_threads(frame.size);
        });
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame);
        scene.set_sun(atmosphere.sun());

        // 1. Mountains, the planet with the stars behind it, and the air and the fog in front.
        Canvas canvas(frame.hdr, frame.depth);
        draw(frame, view, canvas, {mountains, planet, atmosphere, fog});

        // 2. A table or the standard error in place of the picture, if the knob says so.
        if (atmosphere.method.is("tables") && show.index > 0 && show.index < 4)
            look_at(frame, show.is("sky")        ? atmosphere.sky()
                           : show.is("multiple") ? atmosphere.multiple()
                                                 : atmosphere.transmittance());
        if (atmosphere.method.is("truth") && show.is("doubt")) look_at(frame, atmosphere.doubt());

        // 3. Linear light to the codes that a screen expects; bright light fades to white.
        encode_film(frame);
    }
    // [/frame]
};

CHAPTER(AtmosphereChapter)
