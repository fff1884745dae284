// Moment-based transparency, second pass: each surface dimmed by the transmittance from the moments.
#include "15_terrain_water/moment_depth.glsl"
#include "15_terrain_water/moment_transmittance.glsl"

// Transmittance before a depth from six power moments of absorbance.

// The three real roots of c.x + c.y t + c.z t² + c.w t³, in rising order (F. Viete's cosines).
vec3 cubic_roots(vec4 c) {
    vec3 m = c.xyz / c.w;  // of the cubic with 1 before t³
    float third = m.z / 3.0, p = m.y / 3.0 - third * third, q = 0.5 * (m.x - third * m.y) + third * third * third;
    float r = sqrt(max(-p, 0.0)), angle = acos(clamp(-q / max(r * r * r, 1e-30), -1.0, 1.0)) / 3.0;
    vec3 turned = cos(vec3(angle + 2.0943951, angle + 4.1887902, angle));
    return 2.0 * r * turned - third;
}

// `b`: the means of z to z⁴ over all absorbance `all`; `high`: of z⁵ and z⁶; `z`: -1 to 1. As with four moments, of all
// distributions that have them the one with mass at z itself; the others' depths are the roots of a cubic here.
float moment_transmittance_6(vec4 b, vec2 high, float all, float z, float bias, float overestimation) {
    b = mix(b, vec4(0.0, 0.48, 0.0, 0.451), bias);
    high = mix(high, vec2(0.0, 0.45), bias);
    // H c = (1, z, z², z³) for the matrix of moments H = (1 b1 b2 b3; b1 b2 b3 b4; b2 b3 b4 b5; b3 b4 b5 b6): by Cholesky's
    // L D transpose(L).
    float d1 = b.y - b.x * b.x, l21 = (b.z - b.x * b.y) / d1, l31 = (b.w - b.x * b.z) / d1;
    float d2 = b.w - b.y * b.y - l21 * l21 * d1, l32 = (high.x - b.y * b.z - l21 * l31 * d1) / d2;
    float d3 = high.y - b.z * b.z - l31 * l31 * d1 - l32 * l32 * d2;
    vec4 c = vec4(1.0, z, z * z, z * z * z);
    c.y -= b.x * c.x;
    c.z -= b.y * c.x + l21 * c.y;
    c.w -= b.z * c.x + l31 * c.y + l32 * c.z;
    c /= vec4(1.0, d1, d2, d3);
    c.z -= l32 * c.w;
    c.y -= l21 * c.z + l31 * c.w;
    c.x -= b.x * c.y + b.y * c.z + b.z * c.w;
    vec3 t = cubic_roots(c);
    // The cubic through the step function's values at z and the three roots, in Newton's form; its mean is the mass before z.
    vec3 before = vec3(lessThan(t, vec3(z)));
    float f01 = (before.x - overestimation) / (t.x - z), f12 = (before.y - before.x) / (t.y - t.x), f23 = (before.z - before.y) / (t.z - t.y);
    float f012 = (f12 - f01) / (t.y - z), f123 = (f23 - f12) / (t.z - t.x), f0123 = (f123 - f012) / (t.z - z);
    float first = b.x - z, second = b.y - (z + t.x) * b.x + z * t.x;
    float third = b.z - (z + t.x + t.y) * b.y + (z * t.x + z * t.y + t.x * t.y) * b.x - z * t.x * t.y;
    float mass = overestimation + f01 * first + f012 * second + f0123 * third;
    return clamp(exp(-all * mass), 0.0, 1.0);
}

uniform sampler2D moments;
uniform sampler2D absorbance;

layout(location = 0) out vec4 dimmed;  // added up

void put_surface(vec3 radiance, float alpha, vec3 tint) {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 beside = texelFetch(absorbance, at, 0);
    float all = beside.r, least = max(all, 1e-6), bias = transparency_now.moment_bias;
    vec4 means = texelFetch(moments, at, 0) / least;
#if TRANSPARENCY_METHOD == TRANSPARENCY_METHOD_MOMENTS6
    float left = moment_transmittance_6(means, beside.gb / least, all, moment_depth(), 10.0 * bias, transparency_now.overestimation);
#else
    means = mix(means, vec4(0.0, 0.375, 0.0, 0.375), bias);  // of two peaks and an even rest: never singular
    float left = clamp(moment_transmittance(means, all, moment_depth(), transparency_now.overestimation), 0.0, 1.0);
#endif
    dimmed = vec4(radiance, 1.0) * alpha * left;
}
