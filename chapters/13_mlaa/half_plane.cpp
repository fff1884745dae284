#include "13_mlaa/half_plane.h"

namespace lightwalk {

void HalfPlane::draw(Frame& frame) {
    struct {
        glm::vec2 normal, point;
    } line;
    const float angle = glm::radians(angle_deg.value);
    line.normal = {std::sin(angle), std::cos(angle)};                                     // pixel rows run downwards
    line.point = 0.5f * glm::vec2(frame.crop.whole) + offset.value * line.normal - 0.5f;  // of pixels' middles
    line.point -= glm::vec2(frame.crop.origin) + frame.crop.shift;
    frame.compute("half-plane", {.writes = {frame.hdr}}, [&](Compute& pass) {
        pass.use(fill_).set("line", line).set("result", frame.hdr).dispatch_threads(frame.size);
    });
}

}  // namespace lightwalk
