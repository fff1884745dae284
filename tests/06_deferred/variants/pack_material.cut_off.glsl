// wrong: packed
#include "06_deferred/pixel.glsl"
uvec2 pack_material(PixelMaterial m) {
    float gloss = log2(1.0 + min(m.mixed.shininess, most_shininess)) / log2(1.0 + most_shininess);
    uvec4 d = uvec4(255.0 * clamp(vec4(sqrt(m.mixed.diffuse), gloss), 0.0, 1.0));
    uvec3 s = uvec3(255.0 * clamp(sqrt(m.mixed.specular), 0.0, 1.0));
    return uvec2(d.r | d.g << 8 | d.b << 16 | d.a << 24,
                 s.r | s.g << 8 | s.b << 16 | uint(m.occlusion * 127.0) << 24 | uint(m.ambient_specular) << 31);
}
