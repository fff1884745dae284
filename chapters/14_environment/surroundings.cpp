#include "14_environment/surroundings.h"

namespace lightwalk {

Surroundings::Surroundings(Module& owner, Music* heard)
    : World(owner), sphere(*this, "sphere", light, heard ? *heard : music) {
    objects.maps.method.change_default("normal");
    backdrop.shadow.maps = &objects.maps;
    music.in_use = [this, heard] { return !heard && sphere.shown; };
}

// [frame]
void Surroundings::record(Frame& frame) {
    // Cubes of light from the picture of the surroundings, where they are not there already; or from the scene itself: six
    // views of what stands in it.
    light.record(frame, scene());
    probe.record(frame, scene(), light, {backdrop, objects});
}
// [/frame]

}  // namespace lightwalk
