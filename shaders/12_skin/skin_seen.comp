// Skin, shaded where it is seen.
#include "05_shadow_maps/shade_seen.glsl"
#include "12_skin/skin.frag"

vec4 seen_color(vec4 frag_coord) {
    vec4 color, light, after;
    shade_skin(color, light, after);
    return vec4(color.rgb, 1.0);
}
