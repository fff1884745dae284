// Lights a fragment, or takes over what its vertices received.
#include "common/material.glsl"
#include "02_lambert_phong/shading.glsl"

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 uv;
layout(location = 3) flat in uint material_index;
#if METHOD == METHOD_GOURAUD
layout(location = 4) in vec3 lit_diffuse;
layout(location = 5) in vec3 lit_specular;
#endif
layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
#if AMBIENT
layout(scalar) uniform AmbientBlock { vec3 ambient; };
#endif

// [light_pixel]
// The mean over samples × samples points of the pixel, where position and normal are continued linearly from its
// middle: with many samples this is the truth that the methods are measured against.
Lit light_pixel(MaterialData material) {
    vec3 px = dFdx(world_position), py = dFdy(world_position);
    vec3 nx = dFdx(world_normal), ny = dFdy(world_normal);
    Lit sum = Lit(vec3(0.0), vec3(0.0));
    for (int y = 0; y < knobs.samples; ++y)
        for (int x = 0; x < knobs.samples; ++x) {
            vec2 offset = (vec2(x, y) + 0.5) / float(knobs.samples) - 0.5;
            vec3 position = world_position + offset.x * px + offset.y * py;
            vec3 normal = normalize(world_normal + offset.x * nx + offset.y * ny);
            Lit lit = light_surface(position, normal, view.eye, material.shininess);
            sum.diffuse += lit.diffuse;
            sum.specular += lit.specular;
        }
    float count = float(knobs.samples * knobs.samples);
    return Lit(sum.diffuse / count, sum.specular / count);
}
// [/light_pixel]

void main() {
    MaterialData material = materials[material_index];
#if METHOD == METHOD_GOURAUD
    Lit lit = Lit(lit_diffuse, lit_specular);
#else
    Lit lit = light_pixel(material);
#endif
#if AMBIENT
    lit.diffuse += ambient;
#endif
    color = vec4(diffuse_color(material, uv) * lit.diffuse + material.specular * lit.specular + material.emissive, 1.0);
}
