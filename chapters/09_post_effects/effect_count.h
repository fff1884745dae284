// Knobs that override other knobs for one frame.
#pragma once
#include "09_post_effects/post.h"

namespace lightwalk {

/// While it lives: with `effects` of 0 and more so many effects are on, those first that need nothing but their pixel;
/// with fewer, and `reference`, tones are mapped by aces. Then all knobs are what they were.
class KnobsForFrame {
  public:
    KnobsForFrame(Post& post, bool reference, int effects);
    ~KnobsForFrame();
    KnobsForFrame(const KnobsForFrame&) = delete;

  private:
    std::vector<std::pair<KnobBase*, std::string>> before_;
};

}  // namespace lightwalk
