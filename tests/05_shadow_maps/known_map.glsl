// For the check of 05.pcf: maps with known depths, and how many texels were read.
#include "05_shadow_maps/shadow_data.h"

const int check_field_texels = 64;
int check_texels_read = 0, check_texels_gathered = 0;

int map_texels() { return check_field_texels; }

float check_field_depth(ivec2 texel) {
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(check_field_texels)))) return 0.0;
#if FIELD == 1
    return texel.x < 32 ? 0.75 : 0.25;                                             // an edge along v
#elif FIELD == 2
    return 0.5 + 0.3 * ((float(texel.x) + 0.5) / 64.0 - 0.5) - 0.2 * ((float(texel.y) + 0.5) / 64.0 - 0.5);  // a plane
#else
    return (texel.x * 7 + texel.y * 13) % 5 < 2 ? 0.75 : 0.25;                      // single texels
#endif
}

float read_depth(vec2 uv, uint layer) {
    ++check_texels_read;
    return check_field_depth(ivec2(floor(uv * float(check_field_texels))));
}

vec4 gather_depths(vec2 uv, uint layer) {
    check_texels_gathered += 4;
    ivec2 at = ivec2(floor(uv * float(check_field_texels) - 0.5));
    return vec4(check_field_depth(at + ivec2(0, 1)), check_field_depth(at + 1), check_field_depth(at + ivec2(1, 0)), check_field_depth(at));
}

#include "05_shadow_maps/pcf.glsl"

vec3 check_pcf_counted(vec2 uv, float depth, vec2 slope, int kernel) {
    float visible = pcf(Receiver(vec3(uv, depth), slope), 0u, kernel);
    return vec3(visible, check_texels_gathered, check_texels_read);
}
