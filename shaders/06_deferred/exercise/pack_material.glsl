// Exercise 06.pack_material: a material in eight bytes.
// Until you fill it in, everything is grey and matt.
#include "06_deferred/pixel.glsl"

// [pack_material]
// Two words, lowest byte first. The first: red, green and blue of the diffuse colour, and gloss. The second: red, green
// and blue of the specular colour, then 7 bits of occlusion (0 to 127 for 0 to 1), and in the last bit whether
// ambient_specular is 1. A colour's byte is the root of its value, 0 to 255 for 0 to 1: roots keep dark colours apart.
// Gloss is log2(1 + shininess) / log2(1 + most_shininess), 0 to 255 for 0 to 1. Round to the nearest code. Whatever is
// too large or too small for its bits is clamped before: a specular colour of 1.5, an exponent of 100,000.
// [/pack_material]
uvec2 pack_material(PixelMaterial m) {
    return uvec2(0x00b4b4b4u, 0x7f000000u);
}
