// A normal and a material after storage in 8, 12 or 16 bits.
#include "06_deferred/normals.glsl"
#include "06_deferred/pack_material.glsl"

vec3 normal_through(vec3 normal, int bits) { return decode_normal(dequantise(quantise(encode_normal(normal), bits), bits)); }
