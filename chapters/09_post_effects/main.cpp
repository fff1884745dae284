// Chapter 09: from light to the screen. Depth of field, exposure, tone curves and post effects.
#include <list>

#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/depth_of_field.h"
#include "09_post_effects/post.h"
#include "common/app/knob_scope.h"
#include "common/window/run.h"

using namespace lightwalk;

namespace {

// How each is switched on that has more than one way.
const char* on_text(const KnobBase& effect) {
    if (effect.name == "exposure") return "fixed";
    if (effect.name == "tone") return "hill";
    if (effect.name == "grain") return "white";
    return effect.name == "dither" ? "bayer_8" : "on";
}

// One frame's knobs: the given number of effects on, single-pixel ones first; below 0, and with `reference`, tones are mapped by
// aces.
std::list<KnobScope> knobs_for_frame(Post& post, bool reference, int effects) {
    std::list<KnobScope> scopes;
    const auto put = [&](KnobBase& knob, const std::string& text) {
        if (knob.text() != text) scopes.emplace_back(knob, text);
    };
    if (effects < 0) {
        if (reference && !post.tone.is("off")) put(post.tone, "aces");
        return scopes;
    }
    std::vector<KnobBase*> order = post.effects();
    std::rotate(order.begin(), order.begin() + 3, order.end());  // pixel by pixel first
    for (size_t i = 0; i < order.size(); ++i)
        put(*order[i], i < static_cast<size_t>(effects) ? on_text(*order[i]) : "off");
    return scopes;
}

}  // namespace

struct PostEffects : ModelChapter {
    ThroughLens world{*this};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};
    Choice source{*this,
                  "source",
                  {"scene", "chart"},
                  "scene",
                  "Picture to process: the scene, or a chart of light over 15 stops in every hue"};
    Knob<bool> reference{*this, "reference", false, "Use the reference tone curve, ACES, instead of post.tone"};
    Knob<int> effects{*this,
                      "effects",
                      -1,
                      {-1, 16},
                      "Number of effects that are on, in their fixed order; -1: those that are switched on"};
    Pipeline chart = compute({.shader = "09_post_effects/chart.comp"});

    PostEffects() {
        set_look(world, *this);
        world.dof.method.preferred = true;  // --method is about depth of field here: the others are fast and exact
    }
    std::string default_scene() const override { return "scenes/evening.json"; }

    void draw_chart(Frame& frame) {
        frame.compute("chart", {.writes = {frame.hdr}},
                      [&](Compute& pass) { pass.use(chart).set("result", frame.hdr).dispatch_threads(frame.size); });
    }

    // [frame]
    void frame(Frame& frame) override {
        const std::list<KnobScope> kept = knobs_for_frame(post, reference, effects);
        const View view = set_view(frame, world);

        // 1. A picture in linear light: chapter 06's objects, with depth of field (depth_of_field.h).
        Canvas canvas(frame.hdr, frame.depth, world.background());
        if (source.is("chart"))
            draw_chart(frame);
        else
            world.draw_light(frame, view, canvas);

        // 2. Chapter 08's bloom.
        bloom.record(frame, frame.hdr);

        // 3. Exposure, tone curve and post effects.
        post.record(frame, frame.hdr);

        // 4. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(PostEffects)
