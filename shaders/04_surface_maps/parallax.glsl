// Where the eye's ray meets the height field, by the method in use.
#include "04_surface_maps/parallax_offset.glsl"
#include "04_surface_maps/parallax_occlusion.glsl"
#include "04_surface_maps/exact_hit.glsl"

const int halvings = 8;  // of the last step, by relief

// What a ray at a grazing angle is taken for: 1.1 degrees above the surface. Below, a ray crosses without end.
const float lowest_eye = 0.02;

// F. Policarpo, M. Oliveira and J. Comba, "Real-Time Relief Mapping on Arbitrary Polygonal Surfaces", I3D 2005.
// [relief]
float relief(vec2 uv, vec2 shift, int steps) {
    float below = first_layer_below(uv, shift, steps);
    float above = max(below - 1.0 / float(steps), 0.0);
    for (int i = 0; i < halvings; ++i) {
        float middle = 0.5 * (above + below);
        if (middle >= depth_at(uv - middle * shift))
            below = middle;
        else
            above = middle;
    }
    return below;
}
// [/relief]

#define MEASURES_HITS (SHOW == SHOW_HIT_ERROR || SHOW == SHOW_SWIM)

struct Hit {
    vec2 uv;
    float depth;  // 0 at the mesh, 1 at the deepest
};

// How the texture coordinates change on the way from the top to the bottom. `to_eye` is a unit vector in tangent space,
// `deepest` says how many units of u and of v depth 1 is.
vec2 shift_of(vec3 to_eye, vec2 deepest) { return deepest * to_eye.xy / max(to_eye.z, lowest_eye); }

// [find_hit]
Hit find_hit(vec2 uv, vec3 to_eye, vec2 deepest, int steps) {
    vec2 shift = shift_of(to_eye, deepest);
    Hit hit = Hit(uv, 0.0);
#if METHOD == METHOD_OFFSET || METHOD == METHOD_OFFSET_LIMITED
    hit.depth = depth_at(uv);
    to_eye.z = max(to_eye.z, lowest_eye);
#if METHOD == METHOD_OFFSET
    hit.uv += parallax_offset(hit.depth, to_eye, deepest);
#else
    hit.uv += parallax_offset_limited(hit.depth, to_eye, deepest);
#endif
    return hit;
#elif METHOD == METHOD_STEEP
    hit.depth = first_layer_below(uv, shift, steps);
#elif METHOD == METHOD_OCCLUSION
    hit.depth = parallax_occlusion(uv, shift, steps);
#elif METHOD == METHOD_RELIEF
    hit.depth = relief(uv, shift, steps);
#elif METHOD == METHOD_EXACT
    hit.depth = exact_hit(uv, shift);
#endif
    hit.uv = uv - hit.depth * shift;
    return hit;
}
// [/find_hit]

#if MEASURES_HITS
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
#endif
