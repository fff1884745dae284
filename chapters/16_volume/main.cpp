// Chapter 16: volumes: a nebula in a sphere of glass, a head that was scanned.
#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "16_volume/volume.h"
#include "16_volume/volume_file.h"
#include "common/window/run.h"

using namespace lightwalk;

struct VolumeChapter : ModelChapter {
    Volume volume{*this, "volume"};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};

    VolumeChapter() {
        volume.method.alone = true;  // --method is about the march here
    }
    std::string default_scene() const override { return "scenes/nebula.json"; }

    Model load_model(const std::filesystem::path& file) override {
        if (!is_volume_file(file)) return ModelChapter::load_model(file);
        read_volume(file);  // says what is wrong with it
        Model none;
        none.materials.emplace_back();
        return none;
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 1.0f));
        draw(frame, view, canvas, {volume});
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(VolumeChapter)
