// Pixels to where the surface was in the frame before, where it is the one that is seen.
#include "common/structs.h"

uniform sampler2D depth;
layout(scalar) uniform ViewBlock { CameraView view; };
layout(location = 0) in vec4 clip_now;
layout(location = 1) in vec4 clip_before;
layout(location = 0) out vec4 moved;

const float same_depth = 1e-3;  // relative: two vertex shaders round differently

void main() {
    float seen = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
    if (abs(gl_FragCoord.z - seen) > same_depth * seen || clip_before.w <= 0.0) discard;
    vec2 pixels = 0.5 * view.size * (clip_before.xy / clip_before.w - clip_now.xy / clip_now.w);
    moved = vec4(pixels, clip_before.w, 1.0);
}
