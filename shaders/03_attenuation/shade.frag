// Fragment shading, or the number of lights computed.
#include "common/material.glsl"
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/lighting.glsl"
#include "03_attenuation/unshadowed.glsl"

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 uv;
layout(location = 3) flat in uint material_index;
layout(location = 4) flat in uint item;
layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform AmbientBlock { vec3 ambient; };

#if SHOW == SHOW_LIGHT_COUNT
// Heat map: black for 0, then blue, cyan, green, yellow, red and white for 1, 4, 16, 64, 256 and 1,024 lights.
vec3 count_color(uint count) {
    const vec3 colors[] = vec3[](vec3(0.0), vec3(0.0, 0.05, 0.8), vec3(0.0, 0.6, 0.8), vec3(0.0, 0.6, 0.05),
                                 vec3(0.8, 0.7, 0.0), vec3(0.8, 0.05, 0.0), vec3(1.0));
    float step = count == 0u ? 0.0 : clamp(1.0 + 0.5 * log2(float(count)), 1.0, 6.0);
    return mix(colors[uint(step)], colors[min(uint(step) + 1u, 6u)], fract(step));
}
#endif

void main() {
    MaterialData material = materials[material_index];
    vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);
    Surface surface = Surface(normal, normalize(view.eye - world_position), material.shininess, normal);
    Lit lit = light_surface(surface, surface.normal, world_position, item, gl_FragCoord);
    vec3 radiance = diffuse_color(material, uv, view.lod_bias) * (lit.diffuse + ambient) + material.specular * lit.specular +
                    emitted_color(material);
#if SHOW == SHOW_LIGHT_COUNT
    radiance = count_color(lit.lights) * (0.35 + 0.65 * max(surface.normal.y, 0.0));
#endif
    color = vec4(min(radiance, LARGEST_HALF), lit.lights);
}
