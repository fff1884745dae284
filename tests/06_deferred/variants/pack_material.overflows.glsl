// wrong: packed specular
#include "06_deferred/pixel.glsl"
uvec2 pack_material(PixelMaterial m) {
    float gloss = log2(1.0 + min(m.mixed.shininess, most_shininess)) / log2(1.0 + most_shininess);
    uvec3 s = uvec3(sqrt(m.mixed.specular) * 255.0 + 0.5);
    return uvec2(packUnorm4x8(vec4(sqrt(m.mixed.diffuse), gloss)),
                 (s.r | s.g << 8 | s.b << 16) + (uint(m.occlusion * 127.0 + 0.5) << 24) + (uint(m.ambient_specular) << 31));
}
