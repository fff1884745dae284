// The wet, clear skin of the eye: its reflection is added to the picture behind it.
#include "03_attenuation/lighting.glsl"
#include "04_surface_maps/surface_maps.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "05_shadow_maps/bvh.glsl"
#include "common/environment.glsl"
#include "12_skin/kelemen_szirmay_kalos.glsl"

layout(location = 0) out vec4 color;

const float f0 = 0.025, rough = 0.1;

void main() {
    MappedSurface m = map_surface(view.eye, materials[material_index], coordinates_at(view));
    vec3 n = m.facing, v = m.surface.to_eye, mirrored = reflect(-v, n), sum = vec3(0.0);
    // Lids and brows block the mirror image.
    if (dot(n, v) > 0.0 && !any_hit(Ray(above(m.position, n), 0.0, mirrored, on_and_on)))
        sum += schlick_fresnel(dot(n, v), f0) * surroundings_mirrored(mirrored, rough);
    for (uint i = 0u; i < lights_data.length(); ++i) {
        VisibleLight light = visible_light(i, m.position, n, m.surface.plane);
        if (dot(n, light.to_light) <= 0.0 || light.radiance == vec3(0.0)) continue;
        float shine = kelemen_szirmay_kalos(n, light.to_light, v, rough, f0);
        sum += 3.14159265 * shine * light.visible * light.radiance;
    }
    color = vec4(min(sum, LARGEST_HALF), 1.0);
}
