// The spectrum at a time: eight real fields as four complex ones, two to a texel. J. Tessendorf, "Simulating Ocean Water",
// SIGGRAPH course, 2001.
#include "15_terrain_water/water_data.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) readonly buffer OceanWavesBuffer { OceanWave ocean_waves[]; };
layout(scalar) uniform OceanNowBlock { OceanNow ocean_now; };
layout(rgba32f) writeonly uniform image2DArray fields;

vec2 times(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }
vec2 times_i(vec2 a) { return vec2(-a.y, a.x); }

// [ocean_spectrum]
void main() {
    uvec3 at = gl_GlobalInvocationID;
    OceanWave wave = ocean_waves[(at.z * OCEAN_TEXELS + at.y) * OCEAN_TEXELS + at.x];
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
    imageStore(fields, ivec3(at), vec4(moved_x + times_i(h), moved_z + times_i(moved_x_by_z)));
    imageStore(fields, ivec3(at.xy, at.z + 3u), vec4(slope_x + times_i(slope_z), moved_x_by_x + times_i(moved_z_by_z)));
}
// [/ocean_spectrum]
