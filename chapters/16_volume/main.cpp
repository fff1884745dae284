// Chapter 16: volumes: a nebula in a sphere of glass, a head that was scanned.
#include "01_obj/model_chapter.h"
#include "04_surface_maps/surface_scene.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/depth_of_field.h"
#include "09_post_effects/post.h"
#include "16_volume/finish.h"
#include "16_volume/volume.h"
#include "16_volume/volume_file.h"
#include "common/window/run.h"

using namespace lightwalk;

struct VolumeChapter : ModelChapter {
    Finish finish{*this, "finish"};  // before the maps' levels are made of it
    SurfaceScene objects{*this, "objects"};
    Volume volume{*this, "volume"};
    DepthOfField dof{*this, "dof"};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};

    VolumeChapter() {
        volume.method.alone = true;  // --method is about the march here
        objects.maps.method.change_default("flat");
    }
    std::string default_scene() const override { return "scenes/light_in_rings.json"; }

    Model load_model(const std::filesystem::path& file) override {
        if (is_lathe_file(file)) {
            const Lathe lathe = read_lathe(file);
            return lathe_model(lathe, turn_lathe(lathe));
        }
        if (!is_volume_file(file)) return ModelChapter::load_model(file);
        Model none;  // the volume itself reads the file
        none.materials.emplace_back();
        return none;
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 1.0f));

        // 1. Solid objects, blurred by the lens. They alone write depth. So the volume is drawn after the lens: it stays
        //    sharp, and its rays end at the objects.
        dof.record(frame, view, canvas, {objects});
        draw(frame, view, canvas, {volume});

        // 2. The glare of what is bright, the tones of a film and its grain.
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);

        // 3. Linear light to the codes a screen expects.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(VolumeChapter)
