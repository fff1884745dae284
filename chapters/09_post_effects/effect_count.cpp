#include "09_post_effects/effect_count.h"

namespace lightwalk {
namespace {

// How each is switched on that has more than one way.
const char* on_text(const KnobBase& effect) {
    if (effect.name == "exposure") return "fixed";
    if (effect.name == "tone") return "hill";
    if (effect.name == "grain") return "white";
    return effect.name == "dither" ? "bayer_8" : "on";
}

}  // namespace

KnobsForFrame::KnobsForFrame(Post& post, bool reference, int effects) {
    const auto put = [&](KnobBase& knob, const std::string& text) {
        if (knob.text() == text) return;
        before_.emplace_back(&knob, knob.text());
        knob.set(text);
    };
    if (effects < 0) {
        if (reference && !post.tone.is("off")) put(post.tone, "aces");
        return;
    }
    std::vector<KnobBase*> order = post.effects();
    std::rotate(order.begin(), order.begin() + 3, order.end());  // pixel by pixel first
    for (size_t i = 0; i < order.size(); ++i)
        put(*order[i], i < static_cast<size_t>(effects) ? on_text(*order[i]) : "off");
}

KnobsForFrame::~KnobsForFrame() {
    for (const auto& [knob, text] : before_) knob->set(text);
}

}  // namespace lightwalk
