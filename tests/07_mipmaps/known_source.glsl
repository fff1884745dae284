// For the check of 07.box_2x2: a level with known texels; one outside has no value.
#pragma replaces "07_mipmaps/source.glsl"
#include "07_mipmaps/content.glsl"

ivec2 source_size() { return ivec2(FIELD_WIDTH, FIELD_HEIGHT); }
vec4 texel(ivec2 at) {
    bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, source_size()));
    vec2 p = vec2(at);
    return inside ? vec4(p.x, p.y, p.x * p.x, p.x * p.y) : vec4(1e9);
}
