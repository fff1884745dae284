// For the check of 08.blur_line: a line with known texels, and how often each was read.
#include "08_bloom/line_source.glsl"

layout(scalar) buffer CountBuffer { uint check_counts[]; };
uniform sampler2D check_known;
int check_base;
vec3 texel(int i) {
    atomicAdd(check_counts[clamp(i - check_base + 900, 0, check_counts.length() - 1)], 1u);
    return texelFetch(check_known, ivec2(i + 1024, 0), 0).rgb;
}
float weight_at(int distance) { return 1.0 / float(1 + distance); }
