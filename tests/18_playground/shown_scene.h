// A document beside its scene on the device, without a window.
#pragma once
#include <set>

#include "18_playground/live_scene.h"
#include "common/scene_fixture.h"
#include "editor_fixture.h"

namespace lightwalk {

/// A document, and its scene as an editor keeps it.
struct Shown {
    Gpu& gpu = check_device();
    Document document;
    Scene scene;
    LiveScene live;
    Shown() {
        scene.load(gpu, exported(document).scene, test_model);
        live.begin(document, scene);
    }
    LiveScene::Done update() { return live.update(gpu, document, scene, test_model); }
};

/// Items with their placements and numbers, in any order.
inline std::multiset<std::string> items_of(const Scene& scene) {
    std::multiset<std::string> all;
    for (const DrawItem& item : scene.items) {
        std::string text =
            scene.file.objects[item.object].name + fmt::format(" {} {} {}", item.node, item.mesh, item.part);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 3; ++r) text += fmt::format(" {:.9g}", item.transform[c][r]);
        const MaterialNumbers& m = item.material;
        text += fmt::format(" {:.9g} {:.9g} {} {:.9g} {:.9g} {}", m.diffuse.x, m.opacity, item.mirrored, item.roughness,
                            item.metalness, item.transparent);
        all.insert(text);
    }
    return all;
}

}  // namespace lightwalk
