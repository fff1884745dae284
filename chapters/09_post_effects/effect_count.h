// Knobs that override other knobs for one frame.
#pragma once
#include "09_post_effects/post.h"

namespace lightwalk {

/// Scope with the given number of effects on, single-pixel ones first; below 0, and with `reference`, tones are
/// mapped by aces. Restores all knobs.
class KnobsForFrame {
  public:
    KnobsForFrame(Post& post, bool reference, int effects);
    ~KnobsForFrame();
    KnobsForFrame(const KnobsForFrame&) = delete;

  private:
    std::vector<std::pair<KnobBase*, std::string>> before_;
};

}  // namespace lightwalk
