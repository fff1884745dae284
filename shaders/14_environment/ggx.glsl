// The microfacet model of chapter 04, and how to sample it.
#include "04_surface_maps/microfacets.glsl"
#include "05_shadow_maps/sampling.glsl"

// Columns: two directions across `n`, which has unit length and may point anywhere, and `n` itself.
mat3 frame_around(vec3 n) {
    vec3 x, y;
    basis_of(n, x, y);
    return mat3(x, y, n);
}

// Point i of `count`, evenly spread over the square: J. M. Hammersley, 1960; the second number is i's bits in reverse.
vec2 hammersley(uint i, uint count) {
    return vec2((float(i) + 0.5) / float(count), float(bitfieldReverse(i)) * 2.3283064365386963e-10);
}
