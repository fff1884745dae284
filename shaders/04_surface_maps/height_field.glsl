// Intersection of rays with a height map, by each method of the module Maps.
#include "common/structs.h"
#include "04_surface_maps/parallax_offset.glsl"
#include "04_surface_maps/parallax_occlusion.glsl"

// Surface of a height map: depth 0 is the mesh, 1 the deepest point, bilinear between texel centres at full resolution.
// All methods intersect this one surface.
uniform sampler2D height_map;

float depth_at(vec2 uv) { return 1.0 - textureLod(height_map, image_uv(uv), 0.0).r; }

// Exact intersection with the bilinear surface, from one square of four texel centres to the next.
const int most_squares = 8192;

// The map repeats. (% is not defined for negative numbers.)
float texel_depth(ivec2 at, ivec2 size) {
    return 1.0 - texelFetch(height_map, at - size * ivec2(floor(vec2(at) / vec2(size))), 0).r;
}

// Smallest root of a r^2 + b r + c in [0, most] for c > 0; -1: none.
float first_root(float a, float b, float c, float most) {
    float discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return -1.0;
    float q = -0.5 * (b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
    float one = q != 0.0 ? c / q : -1.0, two = a != 0.0 ? q / a : -1.0;
    float root = one < 0.0 ? two : two < 0.0 ? one : min(one, two);
    return root <= most ? root : -1.0;
}

// Depth t at which the ray over uv - t * shift hits the surface. Within a square the depth is bilinear in x and y,
// which are linear in t, so the gap between ray and surface is quadratic in t.
float exact_hit(vec2 uv, vec2 shift) {
    ivec2 size = textureSize(height_map, 0);
    vec2 start = image_uv(fract(uv)) * vec2(size) - 0.5;  // in texels; texel centres are integers
    vec2 along = vec2(-shift.x, shift.y) * vec2(size);    // for t from 0 to 1
    ivec2 square = ivec2(floor(start)), next = ivec2(sign(along));
    vec2 pace = 1.0 / max(abs(along), vec2(1e-9));  // t from one border to the next
    vec2 inside = start - vec2(square);
    vec2 border = mix(inside, 1.0 - inside, greaterThan(along, vec2(0.0))) * pace;  // t at which each is crossed
    float t = 0.0;
    for (int i = 0; i < most_squares; ++i) {
        float end = min(min(border.x, border.y), 1.0);
        float d00 = texel_depth(square, size), d10 = texel_depth(square + ivec2(1, 0), size);
        float d01 = texel_depth(square + ivec2(0, 1), size), d11 = texel_depth(square + ivec2(1, 1), size);
        vec2 slope = vec2(d10 - d00, d01 - d00);
        float twist = d00 - d10 - d01 + d11;
        vec2 p = start + t * along - vec2(square);
        float gap = d00 + dot(slope, p) + twist * p.x * p.y - t;
        if (gap <= 0.0) return t;
        float change = dot(slope, along) + twist * (p.x * along.y + p.y * along.x) - 1.0;
        float root = first_root(twist * along.x * along.y, change, gap, end - t);
        if (root >= 0.0) return t + root;
        if (end >= 1.0) return 1.0;
        t = end;
        bool across = border.x < border.y;
        square += across ? ivec2(next.x, 0) : ivec2(0, next.y);
        border += across ? vec2(pace.x, 0.0) : vec2(0.0, pace.y);
    }
    return 1.0;
}

const int halvings = 8;  // bisection steps of relief mapping

// Lower limit of a ray's elevation, 1.1 degrees; below it the crossing has no end.
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
    float depth;  // 0 at the mesh, 1 at the deepest point
};

// Change of texture coordinates from top to bottom. `to_eye`: unit vector in tangent space; `deepest`: units of u and v
// per depth 1.
vec2 shift_of(vec3 to_eye, vec2 deepest) { return deepest * to_eye.xy / max(to_eye.z, lowest_eye); }

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
