// Chapter 14: a stand-in until the chapter's own frame is there.
#include "01_obj/model_chapter.h"
#include "14_environment/music.h"
#include "common/window/run.h"

using namespace lightwalk;

struct EnvironmentChapter : ModelChapter {
    Music music{*this, "music"};
    std::string default_scene() const override { return "scenes/julia_sunset.json"; }
    void frame(Frame& frame) override { encode_srgb(frame); }
};

CHAPTER(EnvironmentChapter)
