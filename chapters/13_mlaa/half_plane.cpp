#include "13_mlaa/half_plane.h"

namespace lightwalk {

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
