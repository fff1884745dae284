// A throw-away chapter: the drawings of six chapters in one picture; that picture on a screen within itself; and a
// cube of six faces of it. Built twice: its objects are lit by their surroundings, or through a G-buffer behind the
// landscape.
#include "01_obj/model_chapter.h"
#include "06_deferred/deferred_scene.h"
#include "06_deferred/many_lights.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "11_fractals/julia.h"
#include "11_fractals/terrain.h"
#include "13_mlaa/mlaa.h"
#include "14_environment/lit_around.h"
#include "14_environment/probe.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Everything : ModelChapter {
    Atmosphere atmosphere{*this, "atmosphere"};
    Planet planet{*this, "planet", atmosphere};
    HeightFog fog{*this, "fog"};
    Terrain terrain{*this, "terrain"};
    ImageLight light{*this, "environment"};
#ifdef LIGHTWALK_THROUGH_GBUFFER
    DeferredScene objects{*this, "objects"};
#else
    LitAround objects{*this, "objects", light};
#endif
    Screens screens{*this, "screens"};
    SceneProbe probe{*this, "probe"};
    Bloom bloom{*this, "bloom"};
    Mlaa antialias{*this, "mlaa"};
    Post post{*this, "post"};
    EnvironmentLight around{*this, "around"};
    Julia julia{*this, "julia", around};
    Choice world{*this, "world", {"terrain", "julia"}, "terrain", "What the objects stand in"};
    Choice order{*this, "order", {"behind", "before"}, "behind", "The world is drawn first, or the objects are"};
    Choice show{*this, "show", {"picture", "again"}, "picture", "The picture, or the same one drawn a second time"};

    Everything() {
        objects.surfaces.drawn = [this] { return screens.batches(scene); };
        objects.shading.with.emplace_back(screens);
        terrain.own_sky = false;
        terrain.in_use = [this] { return world.is("terrain"); };
        julia.in_use = [this] { return world.is("julia"); };
    }
    std::string default_scene() const override { return "scenes/islands.json"; }

    Drawings drawn() {
        Drawings all;
        if (world.is("julia"))
            all.push_back(julia);
        else {
            all.push_back(terrain);
            all.push_back(planet);
        }
        all.insert(order.is("before") ? all.begin() : all.end(), objects);
        if (world.is("terrain")) {
            all.push_back(atmosphere);
            all.push_back(fog);
        }
        return all;
    }

    void frame(Frame& frame) override {
        const View view = set_view(frame);
        scene.set_sun(atmosphere.sun());
        light.record(frame, scene);
        probe.record(frame, scene, light, drawn());
        screens.record(frame, scene, [&](const View& from, Canvas& into) { draw(frame, from, into, drawn()); });
        for (size_t i = 0; i <= show.index; ++i) {
            Canvas canvas(frame.hdr, frame.depth);
            draw(frame, view, canvas, drawn());
        }
        bloom.record(frame, frame.hdr);
        antialias.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        encode_srgb(frame);
    }
};

CHAPTER(Everything)
