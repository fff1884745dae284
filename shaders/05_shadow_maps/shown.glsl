// Views of the knob `show`, and shading by rays. Alpha: kind of error, for measure().
#define OWN_LIGHT_VISIBILITY
#include "04_surface_maps/reflection.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "05_shadow_maps/shadow_truth.glsl"

const float tolerance = 0.25;  // visibility error not counted as wrong
const float contact_m = 0.1;   // distance within which a shadow must touch its blocker

uint worst = SHADOW_RIGHT;       // worst error of all lights
float least_visible = 1.0;       // minimum over lights with shadows
uint seen_in = 0u;               // 1 + view index for the first light with shadows
float texel_m = 0.0;             // texel width of its map
vec2 texels = vec2(0.0);         // position in its map, texels

float map_visibility(ShadowLight light, vec3 position, vec3 facing, vec3 plane, vec3 to_light) {
#if SHADOW_METHOD == SHADOW_METHOD_NONE
    return 1.0;
#else
    return visibility_in_map(light, position, facing, plane, to_light);
#endif
}

void find_wrong(ShadowLight light, vec3 position, vec3 facing, vec3 plane, vec3 to_light, ShadowView map) {
    float texel = texel_at(map, position);
    ShadowTruth truth = shadow_truth(light, position, facing, to_light, texel * (1.0 + filter_reach(light, map, position)));
    float shown = map_visibility(light, position, facing, plane, to_light);
    worst = max(worst, shadow_error(shown, truth, tolerance, contact_m));
}

vec3 light_visibility(uint index, vec3 position, vec3 facing, vec3 plane, vec3 to_light) {
    ShadowLight light = shadow_lights[index];
    if (light.views == 0u) return vec3(1.0);
    if (dot(facing, to_light) <= 0.0) return vec3(0.0);
    uint number = view_of(light, position);
    ShadowView map = shadow_views[number];
#if SHOW == SHOW_WRONG
    find_wrong(light, position, facing, plane, to_light, map);
#endif
    if (seen_in == 0u) {
        seen_in = 1u + number - light.first_view;
        texel_m = texel_at(map, position);
        texels = light_clip_position(map.to_clip, position).xy * float(map_texels());
    }
#if VISIBILITY == VISIBILITY_RAYS
    float shown = visibility_by_rays(light, position, facing, to_light);
#else
    float shown = map_visibility(light, position, facing, plane, to_light);
#endif
    least_visible = min(least_visible, shown);
    return vec3(shown);
}

vec4 shown(vec4 frag_coord) {
    rays_seed = seed_of(uvec2(frag_coord.xy), view.seed);
    MappedSurface m = seen_surface();
    Lit lit = light_mapped(m, item, frag_coord);
    vec3 radiance = radiance_of(m, lit.diffuse, lit.specular, ambient);
    float light = 0.25 + 0.75 * abs(dot(m.facing, m.surface.to_eye));  // shows shapes
#if SHOW == SHOW_VISIBILITY
    radiance = vec3(least_visible) * light;
#elif SHOW == SHOW_WRONG
    const vec3 colors[] = vec3[](vec3(0.5), vec3(0.9, 0.05, 0.02), vec3(0.02, 0.15, 0.9), vec3(0.9, 0.6, 0.0), vec3(0.5, 0.05, 0.6));
    float shape = light * (0.15 + 0.85 * least_visible);
    radiance = worst == SHADOW_RIGHT ? colors[0] * shape * 0.5 : colors[worst];
#elif SHOW == SHOW_MAP
    // Red, green, blue, yellow for cascades; also cyan and magenta for cube faces.
    const vec3 colors[] = vec3[](vec3(0.35), vec3(0.8, 0.15, 0.1), vec3(0.15, 0.65, 0.15), vec3(0.1, 0.3, 0.9),
                                 vec3(0.8, 0.65, 0.1), vec3(0.1, 0.65, 0.65), vec3(0.65, 0.15, 0.65));
    radiance = colors[min(seen_in, 6u)] * light * (0.3 + 0.7 * least_visible);
#elif SHOW == SHOW_TEXELS
    // Checkerboard of texels: blue where narrower than a pixel, red where 16 times as wide.
    float pixels = texel_m / max(shadow_eye.pixel * length(shadow_eye.position - m.position), 1e-9);
    vec3 wide = mix(vec3(0.1, 0.3, 0.9), vec3(0.9, 0.15, 0.05), clamp(0.25 * log2(max(pixels, 1e-3)), 0.0, 1.0));
    uvec2 square = uvec2(max(texels, 0.0));
    float board = (square.x + square.y) % 2u == 0u ? 1.0 : 0.55;
    radiance = seen_in == 0u ? vec3(0.35 * light) : wide * light * board * (0.3 + 0.7 * least_visible);
#endif
    return vec4(radiance, 1.0 + float(worst));
}
