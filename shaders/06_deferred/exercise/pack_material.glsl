// Exercise 06.pack_material: a material in eight bytes.
// Starter: everything is grey and matt.
#include "06_deferred/pixel.glsl"

// [pack_material]
// Two 32-bit words, with bytes listed from the lowest. The first word holds red, green and
// blue of the diffuse colour, then gloss. The second word holds red, green and blue of the
// specular colour, then 7 bits of occlusion (0 to 127 for 0 to 1) and, in the highest bit,
// whether ambient_specular is 1.
// The byte of a colour is the square root of its value, 0 to 255 for 0 to 1: the root keeps
// dark colours apart. Gloss is log2(1 + shininess) / log2(1 + most_shininess), 0 to 255 for
// 0 to 1. Round to the nearest code. Clamp every value to its range first, for example a
// specular colour of 1.5 or an exponent of 100,000.
// [/pack_material]
uvec2 pack_material(PixelMaterial m) {
    return uvec2(0x00b4b4b4u, 0x7f000000u);
}
