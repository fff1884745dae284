// Smooth noise in three dimensions, and sums of its octaves.
#include "16_volume/lattice_4d.glsl"

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
