#include "13_mlaa/outlines.h"

namespace lightwalk {

Outlines::Outlines(Module& owner) : World(owner) {
    objects.maps.method.change_default("normal");
    julia.in_use = [this] { return subject.is("julia"); };
    terrain.in_use = [this] { return subject.is("terrain"); };
    head.skin.in_use = [this] { return subject.is("head"); };
}

// Surfaces clip their own light, each of a pixel's samples.
void Outlines::clip_light(Frame& frame, const ImageView& light) const {
    if (!clip.is("before") || subject.is("objects")) return;
    frame.compute("clip", {.reads = {light}, .writes = {light}},
                  [&](Compute& pass) { pass.use(clip_).set("hdr", light).dispatch_threads(glm::uvec2(light.size())); });
}

void Outlines::draw_view(Frame& frame, const View& view, Canvas& canvas) {
    draw(frame, view, canvas, drawings());
    if (clips) clip_light(frame, canvas.color(frame));
}

}  // namespace lightwalk
