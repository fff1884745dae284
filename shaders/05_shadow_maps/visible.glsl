// Barycentric weights of a visibility buffer's pixels
// (C. Burns and W. Hunt, "The Visibility Buffer: A Cache-Friendly Approach to Deferred Shading", JCGT 2(2), 2013).
#include "05_shadow_maps/corner_weights.glsl"

uniform usampler2D visible;  // item + 1 and triangle; 0: nothing

// [shares]
// Weights at a pixel's centre, and their screen-space derivatives.
struct Shares {
    vec3 here, across, down;
};

Shares shares_at(vec4 corners[3], ivec2 pixel, ivec2 size) {
    vec4 a = corners[0], b = corners[1], c = corners[2];
    vec2 step = 2.0 / vec2(size), place = (vec2(pixel) + 0.5) * step - 1.0;
    vec3 here = corner_weights(a, b, c, place);
    Shares s = Shares(here, corner_weights(a, b, c, place + vec2(step.x, 0.0)) - here,
                      corner_weights(a, b, c, place + vec2(0.0, step.y)) - here);
    // Clamped: rasterisers round corners, so the centre may lie beside a narrow triangle.
    s.here = max(here, 0.0);
    s.here /= s.here.x + s.here.y + s.here.z;
    return s;
}
// [/shares]
