// wrong: packed diffuse
#include "06_deferred/pixel.glsl"
uvec2 pack_material(PixelMaterial m) {
    float gloss = log2(1.0 + min(m.mixed.shininess, most_shininess)) / log2(1.0 + most_shininess);
    uint specular = packUnorm4x8(vec4(m.mixed.specular, 0.0)), occlusion = uint(m.occlusion * 127.0 + 0.5);
    return uvec2(packUnorm4x8(vec4(m.mixed.diffuse, gloss)), specular | occlusion << 24 | uint(m.ambient_specular) << 31);
}
