// Shading of surfaces with maps under chapter 03's lights, or the error of the bump method.
#include "04_surface_maps/reflection.glsl"
#include "03_attenuation/unshadowed.glsl"
#include "common/put_surface.glsl"

const float white_texels = 32.0;  // error shown as white
const float walk_m = 0.05;        // camera motion along the surface per frame, for swim

#if SHOW == SHOW_HIT_ERROR || SHOW == SHOW_SWIM
// Error of a hit, in texels of the height map.
float hit_error(vec2 uv, vec3 to_eye, vec2 deepest, int steps) {
    vec2 shift = shift_of(to_eye, deepest);
    vec2 exact = uv - exact_hit(uv, shift) * shift;
    return length((find_hit(uv, to_eye, deepest, steps).uv - exact) * vec2(textureSize(height_map, 0)));
}

// Sliding of the texture over the surface in texels as the eye moves: change of the method's error at the point that
// the first eye sees; -1 if the second eye does not see it. `from` and `to`: tangent-space vectors in metres from the
// first ray's hit on the mesh.
float swim(vec2 uv, vec3 from, vec3 to, vec2 deepest, float height_m, int steps) {
    vec3 to_eye = normalize(from);
    vec2 shift = shift_of(to_eye, deepest);
    float depth = exact_hit(uv, shift);
    vec3 point = -to_eye * (height_m * depth / max(to_eye.z, lowest_eye));
    vec2 exact = uv - depth * shift;
    vec3 to_eye_then = normalize(to - point);
    vec2 shift_then = shift_of(to_eye_then, deepest);
    vec2 uv_then = exact + depth * shift_then;  // entry of the second eye's ray
    if (abs(exact_hit(uv_then, shift_then) - depth) > 1e-3) return -1.0;
    vec2 slid = find_hit(uv_then, to_eye_then, deepest, steps).uv - find_hit(uv, to_eye, deepest, steps).uv;
    return length(slid * vec2(textureSize(height_map, 0)));
}

// Error in texels of the height map.
float measured(vec2 uv) {
#if MAPS_HEIGHT && MAPS_MESH == MAPS_MESH_LOADED
    mat3 frame = tangent_space();
    uv -= round(uv);  // as in map_surface()
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

void main() {
#if SHOW == SHOW_HIT_ERROR || SHOW == SHOW_SWIM
    put_surface(vec3(measured(coordinates_at(view).uv) / white_texels), 1.0, vec3(1.0));
#else
    MappedSurface m = seen_surface();
#if SHOW == SHOW_NORMAL
    put_surface(0.5 + 0.5 * m.surface.normal, 1.0, vec3(1.0));
#else
    Lit lit = light_mapped(m, item, gl_FragCoord);
    put_surface(radiance_of(m, lit.diffuse, lit.specular, ambient), m.alpha, m.tint);
#endif
#endif
}
