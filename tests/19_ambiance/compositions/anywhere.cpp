// A throw-away chapter: chapter 15's world as it is, in a mirror, in a cube of six faces, or in a film of five seconds.
#include "01_obj/model_chapter.h"
#include "14_environment/probe.h"
#include "15_terrain_water/shore.h"
#include "19_ambiance/reel.h"
#include "common/app/show_image.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Anywhere : ModelChapter {
    Choice show{*this, "show", {"world", "mirror", "cube"}, "world", "The world, its mirror image, or the cube's -z"};
    Shore shore{*this};
    Mirror glass{*this, "glass"};
    ImageLight around{*this, "around"};
    SceneProbe cube{*this, "cube"};
    Reel reel{*this, "reel"};

    Anywhere() { cube.update.change_default("always"); }
    std::string default_scene() const override { return "scenes/lake_city.json"; }
    void prepare_frame(Gpu& gpu, glm::uvec2 size, float time_s) override {
        reel.prepare_frame(gpu, size, time_s, 0, false);
    }

    void frame(Frame& frame) override {
        const View view = set_view(frame, shore);
        Canvas canvas(frame.hdr, frame.depth, shore.background());
        if (reel.is_open())
            reel.record(frame, frame.time_s);
        else
            shore.draw_light(frame, view, canvas);
        around.record(frame, scene);
        if (show.is("mirror")) glass.record(frame, view, 0.0f, shore);
        if (show.is("mirror")) show_image(frame, glass.image());
        if (show.is("cube")) cube.record(frame, scene, around, shore);
        if (show.is("cube")) show_image(frame, cube.last_face());
        encode_srgb(frame);
    }
};

CHAPTER(Anywhere)
