// MLAA: shares of a pixel by the lines of edges on its four sides.
#include "13_mlaa/line_weight.glsl"

vec4 weights_of(ivec2 pixel) {
    return vec4(line_weight(pixel - ivec2(1, 0), false, 1), line_weight(pixel, false, -1),
                line_weight(pixel - ivec2(0, 1), true, 1), line_weight(pixel, true, -1));
}

#include "13_mlaa/mix_listed.glsl"
