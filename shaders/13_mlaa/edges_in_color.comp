// The edges, or the lengths of their lines, in colour over the picture in grey.
#include "common/light.glsl"
#include "13_mlaa/lines.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) uniform image2D picture;

// From blue for short lines over green to red for long ones.
vec3 hue_of(int back, int ahead) {
    float t = clamp(log2(float(back + ahead - 1)) / 8.0, 0.0, 1.0);
    return clamp(vec3(3.0 * t - 1.0, 1.4 - abs(3.6 * t - 1.5), 1.2 - 3.0 * t), 0.02, 1.0);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    vec3 shown = vec3(0.25 * luminance(clamp(imageLoad(picture, pixel).rgb, 0.0, 1.0)));
    EdgeLine below = line_at(pixel, true), right = line_at(pixel, false);
    bool has_below = below.back > 0, has_right = right.back > 0;
#if LENGTHS
    if (has_below) shown = hue_of(below.back, below.ahead);
    else if (has_right) shown = hue_of(right.back, right.ahead);
#else
    if (has_below || has_right) shown = vec3(has_below ? 1.0 : 0.02, has_below && has_right ? 0.8 : 0.3, has_right ? 1.0 : 0.02);
#endif
    imageStore(picture, pixel, vec4(shown, 1.0));
}
