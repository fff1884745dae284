// Solution of 06.pack_material.
#include "06_deferred/pixel.glsl"

uvec2 pack_material(PixelMaterial m) {
    float gloss = log2(1.0 + clamp(m.mixed.shininess, 0.0, most_shininess)) / log2(1.0 + most_shininess);
    uint diffuse = packUnorm4x8(vec4(sqrt(clamp(m.mixed.diffuse, 0.0, 1.0)), gloss));
    uint specular = packUnorm4x8(vec4(sqrt(clamp(m.mixed.specular, 0.0, 1.0)), 0.0));
    uint occlusion = uint(clamp(m.occlusion, 0.0, 1.0) * 127.0 + 0.5);
    return uvec2(diffuse, specular | occlusion << 24 | uint(m.ambient_specular) << 31);
}
