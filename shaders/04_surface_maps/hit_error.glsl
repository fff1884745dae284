// How far the method in use is from the exact hit: for the pictures that chapter 04 shows of it.
#include "04_surface_maps/parallax.glsl"

// How wrong a hit is, in texels of the height map.
float hit_error(vec2 uv, vec3 to_eye, vec2 deepest, int steps) {
    vec2 shift = shift_of(to_eye, deepest);
    vec2 exact = uv - exact_hit(uv, shift) * shift;
    return length((find_hit(uv, to_eye, deepest, steps).uv - exact) * vec2(textureSize(height_map, 0)));
}

// [swim]
// How far the texture slides over the surface, in texels, when the eye moves from one place to another: for the point
// that the first eye sees, how the method's error there changes. -1 where the second eye does not see the point.
// `from` and `to` are vectors in tangent space, in metres, from where the first ray meets the mesh.
float swim(vec2 uv, vec3 from, vec3 to, vec2 deepest, float height_m, int steps) {
    vec3 to_eye = normalize(from);
    vec2 shift = shift_of(to_eye, deepest);
    float depth = exact_hit(uv, shift);
    vec3 point = -to_eye * (height_m * depth / max(to_eye.z, lowest_eye));
    vec2 exact = uv - depth * shift;
    vec3 to_eye_then = normalize(to - point);
    vec2 shift_then = shift_of(to_eye_then, deepest);
    vec2 uv_then = exact + depth * shift_then;  // where that eye's ray enters
    if (abs(exact_hit(uv_then, shift_then) - depth) > 1e-3) return -1.0;
    vec2 slid = find_hit(uv_then, to_eye_then, deepest, steps).uv - find_hit(uv, to_eye, deepest, steps).uv;
    return length(slid * vec2(textureSize(height_map, 0)));
}
// [/swim]
