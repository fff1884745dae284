#include "common/scene/view.h"

#include <cmath>

namespace lightwalk {

CameraView shader_view(const View& view, const Frame& frame, glm::uvec2 size) {
    return {.view_projection = view.view_projection,
            .eye = view.eye,
            .time_s = frame.time_s,
            .size = size,
            .seed = frame.seed,
            .origin = frame.crop.origin,
            .lod_bias = -0.5f * std::log2(static_cast<float>(frame.samples.count))};
}

void look_from(const View& view, Frame& frame) {
    const CameraView block = shader_view(view, frame, frame.size);
    const auto bytes = std::as_bytes(std::span(&block, 1));
    frame.globals["view"].assign(bytes.begin(), bytes.end());
}

glm::mat4 part_of(const Crop& crop, glm::uvec2 size) {
    const glm::vec2 whole(crop.whole), part(size), first = glm::vec2(crop.origin) + crop.shift;
    if (whole == part && first == glm::vec2(0.0f)) return glm::mat4(1.0f);  // exactly
    const glm::vec2 scale = whole / part, offset = (whole - 2.0f * first) / part - 1.0f;
    glm::mat4 m(1.0f);
    m[0][0] = scale.x, m[1][1] = scale.y;
    m[3][0] = offset.x, m[3][1] = offset.y;
    return m;
}

}  // namespace lightwalk
