// The edges, or the lengths of their lines, in colour over the picture in grey.
#include "common/light.glsl"
#include "13_mlaa/edge_source.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) uniform image2D picture;

// From blue for short lines over green to red for long ones.
vec3 hue_of(uint back, uint ahead) {
    float t = clamp(log2(float(back + ahead - 1u)) / 8.0, 0.0, 1.0);
    return clamp(vec3(3.0 * t - 1.0, 1.4 - abs(3.6 * t - 1.5), 1.2 - 3.0 * t), 0.02, 1.0);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    vec3 shown = vec3(0.25 * luminance(clamp(imageLoad(picture, pixel).rgb, 0.0, 1.0)));
    uint word = distances_at(pixel);
    bool below = byte_of(word, back_below) > 0u, right = byte_of(word, back_right) > 0u;
#if LENGTHS
    if (below) shown = hue_of(byte_of(word, back_below), byte_of(word, ahead_below));
    else if (right) shown = hue_of(byte_of(word, back_right), byte_of(word, ahead_right));
#else
    if (below || right) shown = vec3(below ? 1.0 : 0.02, below && right ? 0.8 : 0.3, right ? 1.0 : 0.02);
#endif
    imageStore(picture, pixel, vec4(shown, 1.0));
}
