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

void HalfPlane::draw(Frame& frame, const View& view, Canvas& canvas) {
    struct {
        glm::vec2 normal, point;
    } line;
    const float angle = glm::radians(angle_deg.value);
    line.normal = {std::sin(angle), std::cos(angle)};                                    // pixel rows run downwards
    line.point = 0.5f * glm::vec2(view.crop.whole) + offset.value * line.normal - 0.5f;  // of pixels' middles
    line.point -= glm::vec2(view.crop.origin) + view.crop.shift;
    const ImageView color = canvas.color_overwritten();
    frame.compute("half-plane", {.writes = {color}}, [&](Compute& pass) {
        pass.use(fill_).set("line", line).set("result", color).dispatch_threads(view.size);
    });
}

}  // namespace lightwalk
