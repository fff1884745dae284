// The level above: texel(p) is one of its texels as numbers that may be averaged, p from (0, 0) to source_size() - 1.
#include "07_mipmaps/content.glsl"

#ifdef FIELD_WIDTH
// For checks: a level whose texels are known; one outside has no value.
ivec2 source_size() { return ivec2(FIELD_WIDTH, FIELD_HEIGHT); }
vec4 texel(ivec2 at) {
    bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, source_size()));
    vec2 p = vec2(at);
    return inside ? vec4(p.x, p.y, p.x * p.x, p.x * p.y) : vec4(1e9);
}
#else
uniform sampler2DArray source;
int layer = 0;
ivec2 source_size() { return textureSize(source, 0).xy; }
vec4 texel(ivec2 at) { return decode(texelFetch(source, ivec3(at, layer), 0)); }
#endif
