// G-buffer encodings: GLSL of the module GBuffer.
#include "06_deferred/pixel.glsl"
#include "06_deferred/pack_material.glsl"
#include "06_deferred/normals.glsl"

#define GBUFFER_IS_PACKED (GBUFFER_METHOD == GBUFFER_METHOD_PACKED || GBUFFER_METHOD == GBUFFER_METHOD_TILED)

// Shading normal and mesh normal in 32 bits; the mesh normal gets what the shading normal leaves.
#if GBUFFER_NORMAL_BITS == GBUFFER_NORMAL_BITS_8
const int normal_bits = 8, facing_bits = 8;
#elif GBUFFER_NORMAL_BITS == GBUFFER_NORMAL_BITS_12
const int normal_bits = 12, facing_bits = 4;
#else
const int normal_bits = 16;
#define GBUFFER_ONE_NORMAL  // shading normal replaces the mesh normal
#endif

#if GBUFFER_IS_PACKED
// [packed]
struct Stored {
    uint normals, diffuse, specular;  // 12 bytes
};

Stored store(Pixel p) {
    uint normals = quantise(encode_normal(p.normal), normal_bits);
#ifndef GBUFFER_ONE_NORMAL
    normals |= quantise(encode_normal(p.facing), facing_bits) << 2 * normal_bits;
#endif
    uvec2 material = pack_material(p.material);
    return Stored(normals, material.x, material.y);
}

Pixel restore(Stored s) {
    Pixel p;
    p.normal = p.facing = decode_normal(dequantise(s.normals, normal_bits));
#ifndef GBUFFER_ONE_NORMAL
    p.facing = decode_normal(dequantise(s.normals >> 2 * normal_bits, facing_bits));
#endif
    vec4 diffuse = unpackUnorm4x8(s.diffuse), specular = unpackUnorm4x8(s.specular & 0xffffffu);
    float shininess = exp2(diffuse.a * log2(1.0 + most_shininess)) - 1.0;
    p.material.mixed = MixedMaterial(diffuse.rgb * diffuse.rgb, specular.rgb * specular.rgb, shininess);
    p.material.occlusion = float(s.specular >> 24 & 127u) / 127.0;
    p.material.ambient_specular = float(s.specular >> 31);
    return p;
}
// [/packed]
#else
struct Stored {
    vec4 normal, diffuse, specular;  // halves: 24 bytes
    vec4 position;                   // floats: 16 bytes; method fat only
};

// In spare channels: the mesh normal as 5 + 5 bits in a half, the triangle's plane as 12 + 12 in a float.
const int half_bits = 5, float_bits = 12;

Stored store(Pixel p) {
    PixelMaterial m = p.material;
    Stored s;
    s.normal = vec4(p.normal, quantise(encode_normal(p.facing), half_bits));
    s.diffuse = vec4(m.mixed.diffuse, m.occlusion + 2.0 * m.ambient_specular);
    s.specular = vec4(m.mixed.specular, m.mixed.shininess);
#if GBUFFER_METHOD == GBUFFER_METHOD_FAT
    s.position = vec4(p.position, quantise(encode_normal(p.plane), float_bits));
#endif
    return s;
}

Pixel restore(Stored s) {
    Pixel p;
    p.normal = normalize(s.normal.xyz);
    p.facing = decode_normal(dequantise(uint(s.normal.a), half_bits));
    p.material.mixed = MixedMaterial(s.diffuse.rgb, s.specular.rgb, s.specular.a);
    p.material.ambient_specular = float(s.diffuse.a >= 2.0);
    p.material.occlusion = s.diffuse.a - 2.0 * p.material.ambient_specular;
#if GBUFFER_METHOD == GBUFFER_METHOD_FAT
    p.plane = decode_normal(dequantise(uint(s.position.a), float_bits));
    p.position = s.position.xyz;
#endif
    return p;
}
#endif
