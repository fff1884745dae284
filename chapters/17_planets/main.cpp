// Chapter 17: the Sun, its planets, and one moon, as their photographs show them.
#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "17_planets/flight.h"
#include "17_planets/stars.h"
#include "common/window/run.h"

using namespace lightwalk;

struct PlanetsChapter : ModelChapter {
    Planets planets{*this, "planets"};
    Stars stars{*this, "stars", planets};
    Flight flight{*this, "flight", planets};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};

    PlanetsChapter() {
        planets.method.alone = true;  // --method is about the law here
        post.tone.change_default("neutral");
        bloom.threshold.value = 1.0f;
    }
    std::string default_scene() const override { return "scenes/saturn.json"; }

    // [frame]
    void frame(Frame& frame) override {
        // 1. The camera: the scene's, or that of a flight, whose position floats cannot hold.
        planets.exposed_for_m.reset();
        View view;
        if (flight.on) {
            const double time_s = static_cast<double>(frame.time_s);
            const Flight::Moment moment = flight.at(time_s, planets.days_at(time_s));
            view = set_view(frame, flight.camera(moment, camera));
            view.exact_eye = moment.eye_m;
        } else {
            view = set_view(frame);
        }

        // 2. Stars, then the bodies over them, the farthest first.
        Canvas canvas(frame.hdr, frame.depth);
        draw(frame, view, canvas, {stars, planets});

        // 3. Glare, tones, and the codes that a screen expects.
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(PlanetsChapter)
