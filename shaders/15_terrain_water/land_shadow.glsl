// The ground's shadow on itself: a ray to the sun, in steps that grow with the distance.
uniform sampler2D heights_between;
layout(scalar) uniform LandBlock {
    float softness, snow_m, forest, rock_deg, strata, bumps;
    vec3 grass_tint, forest_tint, rock_tint;
    int shadow_steps;
} land;

// [shadow]
// Share of the sun's disc that is seen, 0 to 1. The disc is half a degree wide: 120 m away a ridge that stands 1 m below the
// ray hides none of it.
float sun_visible(vec3 from, vec3 to_sun) {
#if LAND_SHADOW == LAND_SHADOW_NONE
    return 1.0;
#else
    float spacing = land_map.spacing_m, highest = land_map.highest_m, t = 1.2 * spacing, free = 1.0;
    for (int i = 0; i < land.shadow_steps && free > 0.0; ++i) {
        vec3 at = from + t * to_sun;
        if (at.y > highest) break;
        vec2 uv = (land_place(at.xz) + 0.5) / float(land_map.samples);
        if (any(notEqual(uv, clamp(uv, 0.0, 1.0)))) break;
        float above = at.y - textureLod(heights_between, uv, 0.0).r;
        free = min(free, 0.5 + (above + 0.15 * spacing) * 110.0 / t);
        t += max(0.5 * above, 0.03 * t + 0.6 * spacing);
    }
    return smoothstep(0.0, 1.0, free);
#endif
}
// [/shadow]
