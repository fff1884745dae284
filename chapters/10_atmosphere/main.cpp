// Chapter 10: the atmosphere of a planet, from the ground to orbit.
#include "01_obj/model_chapter.h"
#include "09_post_effects/post.h"
#include "10_atmosphere/islands.h"
#include "common/app/show_image.h"
#include "common/window/run.h"

using namespace lightwalk;

struct AtmosphereChapter : ModelChapter {
    Islands world{*this};
    Choice show{*this,
                "show",
                {"picture", "transmittance", "multiple", "sky", "doubt"},
                "picture",
                "Image shown: the picture; a table of the method tables; or the relative standard error of the "
                "path-traced reference"};
    Knob<float> gain{*this, "gain", 1.0f, {0.0f, 1e6f}, "Scale factor for the brightness of a displayed table"};

    AtmosphereChapter() {
        world.atmosphere.method.preferred = true;  // --method is about the air here
    }
    std::string default_scene() const override { return "scenes/islands.json"; }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame, world);

        // 1. Mountains, the planet with the stars behind it, and the air and the fog in front (islands.h).
        Canvas canvas(frame.hdr, frame.depth, world.background());
        world.draw_light(frame, view, canvas);

        // 2. A table or the standard error instead of the picture, if the knob says so.
        if (const Image* table = world.atmosphere.table(show.text()))
            show_image(frame, *table, {.gain = glm::vec3(gain)});

        // 3. Linear light, encoded as sRGB; bright light fades to white.
        encode_film(frame);
    }
    // [/frame]
};

CHAPTER(AtmosphereChapter)
