// Occlusion test of a box against a pyramid of farthest depths.
#include "06_deferred/screen_box_data.glsl"
#include "06_deferred/screen_box.glsl"
#include "06_deferred/pyramid_level.glsl"

uniform sampler2D pyramid;  // mip 0 is level 1, half of the depth's size

const float SLACK_PIXELS = 0.0625;    // rounding of positions
const float SLACK_DEPTH = 1.0 + 1e-5;  // rounding of depth

// [is_hidden]
// Sizes are computed: with levels that differ between invocations, llvmpipe's textureSize() gives the first one's to
// all.
float farthest_at(ivec2 texel, int level) {
    ivec2 last = max(ivec2(look.pyramid_pixels) >> level, ivec2(1)) - 1;
    return texelFetch(pyramid, min(texel, last), level - 1).r;
}

bool is_hidden(CulledObject object) {
    if (look.pyramid_levels == 0) return false;
    vec2 size = look.pyramid_pixels;
    ScreenBox box = screen_box(object.center, object.half_size, look.to_clip, size);
    ivec2 low = ivec2(clamp(box.low - SLACK_PIXELS, vec2(0.0), size - 1.0));
    ivec2 high = ivec2(clamp(box.high + SLACK_PIXELS, vec2(0.0), size - 1.0));
    int level = clamp(pyramid_level(low, high), 1, look.pyramid_levels);
    low >>= level;
    high >>= level;
    float farthest = min(min(farthest_at(low, level), farthest_at(ivec2(high.x, low.y), level)),
                         min(farthest_at(ivec2(low.x, high.y), level), farthest_at(high, level)));
    return box.nearest * SLACK_DEPTH < farthest;
}
// [/is_hidden]
