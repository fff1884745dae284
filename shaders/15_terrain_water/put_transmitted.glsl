// Moment-based transparency, second pass: each surface dimmed by what the moments say of those before it.
#include "15_terrain_water/moment_depth.glsl"
#include "15_terrain_water/moment_transmittance.glsl"
#include "15_terrain_water/moment_transmittance_6.glsl"

uniform sampler2D moments;
uniform sampler2D absorbance;

layout(location = 0) out vec4 dimmed;  // added up

void put_surface(vec3 radiance, float alpha) {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 beside = texelFetch(absorbance, at, 0);
    float all = beside.r, least = max(all, 1e-6), bias = transparency_now.moment_bias;
    vec4 means = texelFetch(moments, at, 0) / least;
#if TRANSPARENCY_METHOD == TRANSPARENCY_METHOD_MOMENTS6
    float left = moment_transmittance_6(means, beside.gb / least, all, moment_depth(), 10.0 * bias, transparency_now.overestimation);
#else
    float left = moment_transmittance(means, all, moment_depth(), bias, transparency_now.overestimation);
#endif
    dimmed = vec4(radiance, 1.0) * alpha * left;
}
