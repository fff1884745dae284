// Tint of transparent surfaces: the share of light that passes where alpha lets it, by channel.
#include "15_terrain_water/tint_through.glsl"

vec3 used_tint(vec3 tint) {
#if TRANSPARENCY_TINT == TRANSPARENCY_TINT_GREY
    return vec3((tint.r + tint.g + tint.b) / 3.0);
#else
    return tint;
#endif
}
