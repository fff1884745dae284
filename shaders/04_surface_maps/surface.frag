// A surface with all its maps, lit by chapter 03's lights; or what its method of showing bumps gets wrong.
#include "03_attenuation/lighting.glsl"
#include "03_attenuation/unshadowed.glsl"
#include "04_surface_maps/hit_error.glsl"
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform AmbientBlock { vec3 ambient; };

const float white_texels = 32.0;  // an error that SHOW shows as white
const float walk_m = 0.05;        // by which the eye comes closer along the surface from one frame to the next: for swim

#if SHOW == SHOW_HIT_ERROR || SHOW == SHOW_SWIM
// In texels of the height map.
float measured(vec2 uv) {
#if MAPS_HEIGHT && MAPS_MESH == MAPS_MESH_LOADED
    mat3 frame = tangent_space();
    uv -= round(uv);  // as map_surface() has it
#if SHOW == SHOW_HIT_ERROR
    return hit_error(uv, along_uv(normalize(view.eye - world_position) * frame, cos_uv), deepest(), maps.steps);
#else
    vec3 from = (view.eye - world_position) * frame;
    vec3 to = from - vec3(normalize(from.xy + 1e-6) * walk_m, 0.0);
    return swim(uv, along_uv(from, cos_uv), along_uv(to, cos_uv), deepest(), maps.height_m, maps.steps);
#endif
#else
    return 0.0;
#endif
}
#endif

// [main]
void main() {
    Coordinates at = coordinates_at(view);
#if SHOW == SHOW_HIT_ERROR || SHOW == SHOW_SWIM
    color = vec4(vec3(measured(at.uv) / white_texels), 1.0);
#else
    MappedSurface m = map_surface(view.eye, materials[material_index], at);
    if (is_cut_out(m.alpha, maps.cutoff)) discard;
#if SHOW == SHOW_NORMAL
    color = vec4(0.5 + 0.5 * m.surface.normal, 1.0);
#else
    Lit lit = light_surface(m.surface, m.facing, m.position, item, gl_FragCoord);
    color = vec4(radiance_of(m, lit.diffuse, lit.specular, ambient), 1.0);
#endif
#endif
}
// [/main]
