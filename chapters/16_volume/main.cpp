// Chapter 16: volumes: a nebula in a sphere of glass, a head that was scanned.
#include "09_post_effects/finished_chapter.h"
#include "16_volume/volume_world.h"

using namespace lightwalk;

struct VolumeChapter : FinishedChapter<VolumeWorld> {
    VolumeChapter() {
        world.volume.method.preferred = true;  // --method is about the march here
    }
    std::string default_scene() const override { return "scenes/light_in_rings.json"; }
};

CHAPTER(VolumeChapter)
