// Solution of 08.down_filter. J. Jimenez, "Next generation post processing in Call of Duty: Advanced Warfare", 2014.
#include "08_bloom/level_source.glsl"

vec3 down_filter(ivec2 at) {
    vec3 inner = above(at, vec2(-1.0, -1.0)) + above(at, vec2(1.0, -1.0)) + above(at, vec2(-1.0, 1.0)) +
                 above(at, vec2(1.0, 1.0));
    vec3 corners = above(at, vec2(-2.0, -2.0)) + above(at, vec2(2.0, -2.0)) + above(at, vec2(-2.0, 2.0)) +
                   above(at, vec2(2.0, 2.0));
    vec3 edges = above(at, vec2(0.0, -2.0)) + above(at, vec2(-2.0, 0.0)) + above(at, vec2(2.0, 0.0)) +
                 above(at, vec2(0.0, 2.0));
    return 0.125 * (inner + above(at, vec2(0.0))) + 0.0625 * edges + 0.03125 * corners;
}
