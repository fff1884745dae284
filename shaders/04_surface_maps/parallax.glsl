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
#if MAPS_METHOD == MAPS_METHOD_OFFSET || MAPS_METHOD == MAPS_METHOD_OFFSET_LIMITED
    hit.depth = depth_at(uv);
    to_eye.z = max(to_eye.z, lowest_eye);
#if MAPS_METHOD == MAPS_METHOD_OFFSET
    hit.uv += parallax_offset(hit.depth, to_eye, deepest);
#else
    hit.uv += parallax_offset_limited(hit.depth, to_eye, deepest);
#endif
    return hit;
#elif MAPS_METHOD == MAPS_METHOD_STEEP
    hit.depth = first_layer_below(uv, shift, steps);
#elif MAPS_METHOD == MAPS_METHOD_OCCLUSION
    hit.depth = parallax_occlusion(uv, shift, steps);
#elif MAPS_METHOD == MAPS_METHOD_RELIEF
    hit.depth = relief(uv, shift, steps);
#elif MAPS_METHOD == MAPS_METHOD_EXACT
    hit.depth = exact_hit(uv, shift);
#endif
    hit.uv = uv - hit.depth * shift;
    return hit;
}
// [/find_hit]
