// Chapter 14: light from all around, out of a picture or out of the scene itself.
#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "14_environment/backdrop.h"
#include "14_environment/beat_sphere.h"
#include "14_environment/lit_around.h"
#include "14_environment/probe.h"
#include "common/window/run.h"

using namespace lightwalk;

struct EnvironmentChapter : ModelChapter {
    ImageLight light{*this, "environment"};
    Backdrop backdrop{*this, "backdrop", light};
    LitAround objects{*this, "objects", light};
    Music music{*this, "music"};
    BeatSphere sphere{*this, "sphere", light, music};
    SceneProbe probe{*this, "probe"};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};

    EnvironmentChapter() {
        light.method.alone = true;  // --method is about reflections here
        objects.maps.method.change_default("normal");
        backdrop.shadow.maps = &objects.maps;
        bloom.method.change_default("none");
    }
    std::string default_scene() const override { return "scenes/lacquered_statue.json"; }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame);

        // 1. Cubes of light from the picture of the surroundings, where they are not there already.
        light.record(frame, scene);

        // 2. Or from the scene itself: six views of what stands in it.
        probe.record(frame, scene, light, {backdrop, objects});

        // 3. The surroundings, then what stands in them.
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 1.0f));
        draw(frame, view, canvas, {backdrop, objects, sphere});

        // 4. Chapter 08's bloom, chapter 09's tones, and the codes a screen expects.
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(EnvironmentChapter)
