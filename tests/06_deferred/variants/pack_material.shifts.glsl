// right
#include "06_deferred/pixel.glsl"
uint byte_of(float x) { return uint(round(clamp(x, 0.0, 1.0) * 255.0)); }
uvec2 pack_material(PixelMaterial m) {
    vec3 d = sqrt(max(m.mixed.diffuse, vec3(0.0))), s = sqrt(max(m.mixed.specular, vec3(0.0)));
    float gloss = log(1.0 + min(m.mixed.shininess, most_shininess)) / log(1.0 + most_shininess);
    uint first = byte_of(d.r) | byte_of(d.g) << 8 | byte_of(d.b) << 16 | byte_of(gloss) << 24;
    uint second = byte_of(s.r) | byte_of(s.g) << 8 | byte_of(s.b) << 16;
    second |= uint(round(127.0 * clamp(m.occlusion, 0.0, 1.0))) << 24;
    if (m.ambient_specular > 0.5) second |= 0x80000000u;
    return uvec2(first, second);
}
