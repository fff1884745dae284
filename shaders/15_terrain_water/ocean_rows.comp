// The spectrum at a time, and its transform along x: eight real fields as four complex ones, two to a texel. Each
// workgroup takes two rows of a tile. J. Tessendorf, "Simulating Ocean Water", SIGGRAPH course, 2001.
#include "15_terrain_water/water_data.h"
#include "15_terrain_water/ocean_transform.glsl"

layout(scalar) readonly buffer OceanWavesBuffer { OceanWave ocean_waves[]; };
layout(scalar) uniform OceanNowBlock { OceanNow ocean_now; };
layout(scalar) writeonly buffer FinishedBuffer { uint finished[]; };
layout(rgba32f) writeonly uniform image2DArray fields;

vec2 times_i(vec2 a) { return vec2(-a.y, a.x); }

// [ocean_spectrum]
void spectrum(OceanWave wave, out vec4 moved, out vec4 sloped) {
    // Whole cycles, so that nothing is lost however late it is.
    float phase = 6.2831853 * fract(wave.cycles * ocean_now.passed);
    vec2 turn = vec2(cos(phase), -sin(phase));  // along k, as time goes on
    vec2 h = times(wave.forward, turn) + times(wave.backward, vec2(turn.x, -turn.y));
    float size = length(wave.k);
    vec2 unit = size > 0.0 ? wave.k / size : vec2(0.0), chop = ocean_now.chop * unit;
    // Two real fields a and b are the real and the imaginary part of the transform of a + i b.
    vec2 ih = times_i(h);
    vec2 moved_x = chop.x * ih, moved_z = chop.y * ih;
    vec2 moved_x_by_z = -chop.x * wave.k.y * h, moved_x_by_x = -chop.x * wave.k.x * h, moved_z_by_z = -chop.y * wave.k.y * h;
    vec2 slope_x = wave.k.x * ih, slope_z = wave.k.y * ih;
    moved = vec4(moved_x + times_i(h), moved_z + times_i(moved_x_by_z));
    sloped = vec4(slope_x + times_i(slope_z), moved_x_by_x + times_i(moved_z_by_z));
}
// [/ocean_spectrum]

void main() {
    uint column = gl_LocalInvocationIndex, first_row = 2u * gl_WorkGroupID.x, part = gl_WorkGroupID.y;
    if (gl_WorkGroupID.xy == uvec2(0) && column < 6u) finished[column] = 0u;  // for ocean_columns.comp
    for (uint i = 0u; i < 2u; ++i) {
        uint wave = (part * OCEAN_TEXELS + first_row + i) * OCEAN_TEXELS + column;
        vec4 moved, sloped;
        spectrum(ocean_waves[wave], moved, sloped);
        line[i * OCEAN_TEXELS + column] = moved;
        line[(2u + i) * OCEAN_TEXELS + column] = sloped;
    }
    transform();
    for (uint i = 0u; i < 4u; ++i)
        imageStore(fields, ivec3(column, first_row + i % 2u, part + i / 2u * 3u), line[i * OCEAN_TEXELS + column]);
}
