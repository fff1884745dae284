// Moment-based transparency, second pass: each surface dimmed by what the moments say of those before it.
#include "15_terrain_water/moment_depth.glsl"
#include "15_terrain_water/moment_transmittance.glsl"

uniform sampler2D moments;
uniform sampler2D absorbance;

layout(location = 0) out vec4 dimmed;  // added up

void put_surface(vec3 radiance, float alpha) {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float all = texelFetch(absorbance, at, 0).r;
    vec4 means = texelFetch(moments, at, 0) / max(all, 1e-6);
    float left = moment_transmittance(means, all, moment_depth(), transparency_now.moment_bias,
                                      transparency_now.overestimation);
    dimmed = vec4(radiance, 1.0) * alpha * left;
}
