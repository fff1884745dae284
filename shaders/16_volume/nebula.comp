// A nebula: ridges of warped noise, wound around a hot core, in a ball. Or a cloud: billows above a flat base.
#include "16_volume/lattice_4d.glsl"

// Smooth noise in three dimensions, and sums of its octaves.

// -1 to 1; its gradient has no steps. `layer` gives other numbers for the same place.
float noise_3d(vec3 at, int layer) {
    vec3 whole = floor(at), f = at - whole, s = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    ivec3 cell = ivec3(whole);
    float sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = (ivec3(i) >> ivec3(0, 1, 2)) & 1;
        vec3 weight = mix(1.0 - s, s, vec3(corner));
        sum += weight.x * weight.y * weight.z * lattice_4d(ivec4(cell + corner, layer));
    }
    return sum;
}

// Octaves of half the size and half the height, about -1 to 1.
float octaves_3d(vec3 at, int layer, int octaves) {
    float sum = 0.0, height = 0.55;
    for (int i = 0; i < octaves; ++i) {
        sum += height * noise_3d(at, layer + i);
        at = 2.03 * at.yzx + vec3(1.7, 5.3, 2.9);
        height *= 0.5;
    }
    return sum;
}

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(r16f) writeonly uniform image3D result;
layout(scalar) uniform NebulaBlock { int variety; } nebula;

#if NEBULA_SHAPE == NEBULA_SHAPE_CLOUD
float shape_density(vec3 at) {
    float radius = length(at);
    if (radius >= 1.0) return 0.0;
    int layer = 64 * nebula.variety;
    vec3 place = at + 0.1 * vec3(noise_3d(2.3 * at, layer), noise_3d(2.3 * at + 17.0, layer + 1), noise_3d(2.3 * at - 23.0, layer + 2));
    float heaps = 0.5 * octaves_3d(2.4 * place + 5.0, layer + 8, 2);
    // The creases of |noise| lie deep, and its heaps are round.
    float billows = 0.0, size = 4.3, height = 0.3;
    for (int i = 0; i < 4; ++i) {
        billows += height * (abs(noise_3d(size * place, layer + 16 + i)) - 0.2);
        size *= 2.07;
        height *= 0.5;
    }
    float body = 0.66 - length(vec3(0.9, 1.25, 0.95) * at + vec3(0.0, 0.25, 0.0)) + heaps + billows;
    float base = smoothstep(-0.5, -0.36, at.y + 0.25 * heaps + 0.2 * billows);
    return clamp(8.0 * body, 0.0, 1.0) * base * (1.0 - smoothstep(0.86, 0.98, radius));
}
#else
float shape_density(vec3 at) {
    float radius = length(at);
    if (radius >= 1.0) return 0.0;
    int layer = 64 * nebula.variety;
    // Wound up: the nearer to the middle, the farther it is turned.
    float turn = 2.2 / (0.35 + radius) - 1.0;
    vec3 wound = vec3(cos(turn) * at.x - sin(turn) * at.z, at.y, sin(turn) * at.x + cos(turn) * at.z);
    vec3 warp = vec3(noise_3d(1.9 * wound, layer), noise_3d(1.9 * wound + 17.0, layer + 1), noise_3d(1.9 * wound - 23.0, layer + 2));
    vec3 place = wound + 0.35 * warp;
    float ridge = 1.0 - abs(octaves_3d(2.6 * place + 3.0, layer + 8, 5)) * 2.1;
    float clouds = octaves_3d(1.7 * place - 7.0, layer + 24, 4);
    float strands = pow(clamp(ridge, 0.0, 1.0), 3.0) * smoothstep(-0.25, 0.45, clouds);
    float disc = exp(-2.2 * at.y * at.y);
    float fade = 1.0 - smoothstep(0.68, 0.98, radius + 0.1 * clouds);
    float heart = 0.9 * exp(-34.0 * radius * radius);
    return clamp((1.25 * strands * mix(0.5, 1.0, disc) + heart * (0.6 + 0.6 * ridge)) * fade, 0.0, 1.0);
}
#endif

void main() {
    ivec3 voxel = ivec3(gl_GlobalInvocationID), size = imageSize(result);
    if (any(greaterThanEqual(voxel, size))) return;
    imageStore(result, voxel, vec4(shape_density((vec3(voxel) + 0.5) / vec3(size) * 2.0 - 1.0)));
}
