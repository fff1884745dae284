// Surfaces other than skin, shaded as they are drawn, or in compute by matt_seen.comp: an eyeball below its cornea, which is
// dark below the lids, and cloth.
#include "03_attenuation/lighting.glsl"
#include "12_skin/matt_color.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "common/environment.glsl"

uniform sampler2D eye_occlusion;

vec3 matt_radiance() {
    MappedSurface m = map_surface(view.eye, materials[material_index], coordinates_at(view));
    float occlusion = 1.0;
#if EYE
    occlusion = textureLod(eye_occlusion, image_uv(uv), 0.0).r;
#endif
    vec3 sum = occlusion * surroundings_light(m.facing);
    for (uint i = 0u; i < lights_data.length(); ++i) {
        VisibleLight light = visible_light(i, m.position, m.facing, m.surface.plane);
        // Light goes through the white of the eye, too: its edge is soft.
        sum += light.visible * max((dot(m.facing, light.to_light) + 0.2) / 1.44, 0.0) * sqrt(occlusion) * light.radiance;
    }
    return min(matt_color(m.substance) * sum + m.glow, LARGEST_HALF);
}

#ifndef SEEN
layout(location = 0) out vec4 color;

void main() { color = vec4(matt_radiance(), 1.0); }
#endif
