// The water's surface: displaced positions, slopes, and the variance of slopes too fine to resolve.
#include "15_terrain_water/gerstner.glsl"
#include "15_terrain_water/gerstner_normal.glsl"
#include "15_terrain_water/water_data.h"

layout(scalar) uniform WaterNowBlock { WaterNow water_now; };
uniform sampler2DArray ocean_moved;   // of each cascade: displacement; Jacobian's first part
uniform sampler2DArray ocean_sloped;  // of each cascade: dy/dx, dy/dz, dDx/dx, dDz/dz

struct WaterPoint {
    vec3 moved;     // metres
    mat3 slopes;    // as 15.gerstner_normal sums them
    float hidden;   // variance of the slopes that are left out, both axes
};

// How much of a wave is drawn where points are `spacing` apart: none that would be shorter than two of them.
float drawn_share(float wavelength, float spacing) { return smoothstep(2.0, 4.0, wavelength / max(spacing, 1e-6)); }

// Distance of neighbouring points of the rings (water.vert) at that distance from their middle.
float ring_spacing(float radius) { return radius * max(water_now.growth - 1.0, water_now.wide_rad / float(SPOKES)); }

// One part of the ocean, sampled every `spacing` metres.
vec4 ocean_point(sampler2DArray of, vec2 at, int part, float spacing) {
    float texels = spacing * float(textureSize(of, 0).x) / water_now.tile_m[part];
    return textureLod(of, vec3(at / water_now.tile_m[part], float(part)), log2(max(texels, 1.0)));
}

// The point that rests at `at` = (x, z), with the surface sampled every `spacing` metres.
WaterPoint water_at(vec2 at, float spacing) {
    WaterPoint p = WaterPoint(vec3(0.0), mat3(0.0), 0.0);
#if WATER_METHOD == WATER_METHOD_SINES || WATER_METHOD == WATER_METHOD_GERSTNER
    for (uint i = 0u; i < water_now.waves; ++i) {
        WaveData w = water_now.wave[i];
        float size = length(w.k), share = drawn_share(6.2831853 / size, spacing), slope = size * w.amplitude;
        p.hidden += 0.5 * slope * slope * (1.0 - share * share);
        if (share == 0.0) continue;
        p.moved += gerstner(at, w.k, share * w.amplitude, w.steepness, w.phase);
        p.slopes += gerstner_slopes(at, w.k, share * w.amplitude, w.steepness, w.phase);
    }
#elif WATER_METHOD == WATER_METHOD_FFT
    for (int i = 0; i < 3; ++i) {
        vec4 moved = ocean_point(ocean_moved, at, i, spacing), sloped = ocean_point(ocean_sloped, at, i, spacing);
        p.moved += moved.xyz;
        p.slopes[0] += vec3(sloped.z, sloped.x, moved.w);
        p.slopes[2] += vec3(moved.w, sloped.y, sloped.w);
        float share = drawn_share(water_now.cut_m[i], spacing);
        p.hidden += (1.0 - share * share) * water_now.hidden[i];
    }
#endif
    return p;
}

// How much the surface is stretched at a place, as an area: below 0 it is folded.
float jacobian(mat3 slopes) {
    return (1.0 + slopes[0].x) * (1.0 + slopes[2].z) - slopes[0].z * slopes[2].x;
}
