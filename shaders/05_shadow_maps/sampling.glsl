// Low-discrepancy points on a square and a disc, scrambled by a seed.

// Hash of three words: pcg3d (M. Jarzynski and M. Olano, "Hash Functions for GPU Rendering", JCGT
// 9(3), 2020).
uint seed_of(uvec2 pixel, uint seed) {
    uvec3 v = uvec3(pixel, seed) * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    return v.x;
}

// Owen scrambling by a hash: each binary digit is flipped depending on all higher digits
// (S. Laine and T. Karras, 2011, with the constants of B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4),
// 2020). It keeps the points' stratification and makes estimates unbiased over seeds.
uint scramble(uint digits, uint seed) {
    uint x = bitfieldReverse(digits) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return bitfieldReverse(x);
}

// First two dimensions of I. M. Sobol's sequence (1967): 2^k consecutive points from a multiple of 2^k on occupy one
// each of 2^k equal boxes, for every division of the square. 0 <= x, y < 1. The second matrix is Pascal's triangle
// modulo 2, whose entry (j, i) is odd if all bits of i are in j (E. Lucas, 1878), so the sum over j takes five steps,
// one for each bit of a digit's index.
vec2 sobol_point(uint index, uint seed) {
    uint sum = index;
    sum ^= sum >> 1u & 0x55555555u;
    sum ^= sum >> 2u & 0x33333333u;
    sum ^= sum >> 4u & 0x0f0f0f0fu;
    sum ^= sum >> 8u & 0x00ff00ffu;
    sum ^= sum >> 16u & 0x0000ffffu;
    uvec2 digits = bitfieldReverse(uvec2(index, sum));
    return vec2(scramble(digits.x, seed) >> 8u, scramble(digits.y, seed_of(uvec2(seed), 1u)) >> 8u) / 16777216.0;
}

// Area-preserving map from the square to the unit disc.
vec2 on_disc(vec2 point) {
    float angle = 6.2831853 * point.y;
    return sqrt(point.x) * vec2(cos(angle), sin(angle));
}

// Tangent and bitangent of the unit vector `n` (T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1),
// 2017).
void basis_of(vec3 n, out vec3 x, out vec3 y) {
    float s = n.z < 0.0 ? -1.0 : 1.0, a = -1.0 / (s + n.z), b = n.x * n.y * a;
    x = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    y = vec3(b, s + n.y * n.y * a, -n.y);
}
