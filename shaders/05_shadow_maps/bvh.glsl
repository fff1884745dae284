// Ray traversal of a bounding-volume hierarchy: GLSL of the module Rays.
#include "04_surface_maps/cutout.glsl"
#include "05_shadow_maps/bvh_data.h"
#include "common/structs.h"

layout(scalar) readonly buffer RayNodeBuffer { BvhNode rays_nodes[]; };
layout(scalar) readonly buffer RayTriangleBuffer { RayTriangle rays_triangles[]; };
layout(scalar) uniform RayStateBlock { RayState rays_state; };

const float on_and_on = 1e13;

// Ray origin, offset along the mesh normal `facing` against self-shadowing.
vec3 above(vec3 position, vec3 facing) { return position + rays_state.offset_m * facing; }

// Cut-outs of hit triangles, by chapter 04's rule, from texels in a buffer: a ray may hit any of the scene's textures.
#ifndef RAYS_SOLID
layout(scalar) readonly buffer RayCutoutBuffer { RayCutout rays_cutouts[]; };
layout(scalar) readonly buffer RayMaskBuffer { RayMask rays_masks[]; };
layout(scalar) readonly buffer RayTexelBuffer { uint rays_texels[]; };

float mask_texel(RayMask mask, ivec2 at) {
    uint texel = uint(at.y) * mask.width + uint(at.x);
    return float(rays_texels[mask.first + texel / 4u] >> 8u * (texel % 4u) & 255u) / 255.0;
}

// Texel from -1 to the size of a repeating or clamped axis, from -1 to twice the size of a mirroring one.
int wrapped(int texel, int size, uint wrap) {
    if (wrap == MASK_CLAMPS) return clamp(texel, 0, size - 1);
    if (wrap == MASK_REPEATS) return (texel + size) % size;
    int place = (texel + 2 * size) % (2 * size);
    return min(place, 2 * size - 1 - place);
}

float wrapped(float place, uint wrap) {
    return wrap == MASK_CLAMPS ? clamp(place, 0.0, 1.0) : wrap == MASK_REPEATS ? fract(place) : 2.0 * fract(0.5 * place);
}

// Bilinear read, as a sampler's of level 0; v = 0 is the bottom row.
float mask_at(RayMask mask, vec2 uv) {
    ivec2 size = ivec2(mask.width, mask.height);
    vec2 at = vec2(wrapped(uv.x, mask.wrap_u), wrapped(1.0 - uv.y, mask.wrap_v)) * vec2(size) - 0.5;
    ivec2 low = ivec2(floor(at));
    vec2 part = at - vec2(low);
    ivec2 from = ivec2(wrapped(low.x, size.x, mask.wrap_u), wrapped(low.y, size.y, mask.wrap_v));
    ivec2 to = ivec2(wrapped(low.x + 1, size.x, mask.wrap_u), wrapped(low.y + 1, size.y, mask.wrap_v));
    return mix(mix(mask_texel(mask, from), mask_texel(mask, ivec2(to.x, from.y)), part.x),
               mix(mask_texel(mask, ivec2(from.x, to.y)), mask_texel(mask, to), part.x), part.y);
}

// Mask 0 has no holes.
bool is_hole(RayCutout cutout, vec3 weights, RayState now) {
    vec2 color_uv = mat3x2(cutout.color_uv[0], cutout.color_uv[1], cutout.color_uv[2]) * weights;
    vec2 opacity_uv = mat3x2(cutout.opacity_uv[0], cutout.opacity_uv[1], cutout.opacity_uv[2]) * weights;
    color_uv = moving_uv(color_uv, now.wobble, now.scroll, now.time_s);
    opacity_uv = moving_uv(opacity_uv, now.wobble, now.scroll, now.time_s);
    float color_alpha = mask_at(rays_masks[now.color_cuts * cutout.color_mask], color_uv);
    float opacity = mask_at(rays_masks[now.opacity_cuts * cutout.opacity_mask], opacity_uv);
    float alpha = surface_alpha(color_alpha, opacity, dot(cutout.alpha, weights));
    return is_cut_out(alpha, cutout.cutoff < 0.0 ? now.cutoff : cutout.cutoff);
}
#endif

// Ray from `least` to `most`, in multiples of its direction, which need not have unit length.
struct Ray {
    vec3 origin;  // metres, world space
    float least;
    vec3 direction;
    float most;
};

struct RayHit {
    float t;        // in multiples of the ray's direction
    uint triangle;  // in rays_triangles
    vec3 weights;   // barycentric coordinates
};

// Translation and shear that turn the ray into an axis through the origin, so that triangle tests are two-dimensional
// (S. Woop, C. Benthin and I. Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013).
struct Shear {
    bool along_x, along_y;  // dominant axis of the direction; neither: z
    vec3 shear;
};

// Axes rotated so that the dominant one is last.
vec3 turned(vec3 v, bool along_x, bool along_y) { return along_x ? v.yzx : along_y ? v.zxy : v; }

Shear shear_of(vec3 direction) {
    vec3 size = abs(direction);
    bool along_x = size.x >= size.y && size.x >= size.z, along_y = !along_x && size.y >= size.z;
    vec3 d = turned(direction, along_x, along_y);
    return Shear(along_x, along_y, vec3(d.xy, 1.0) / d.z);
}

// Watertight without the paper's fallback to double precision. Each edge function is a difference of two products;
// rounding can make it 0 but not flip its sign, and triangles that share an edge get opposite values. With 0 counted as
// inside, no ray passes between them. `precise`: the sums must be evaluated as written.
bool hit_triangle(RayTriangle triangle, Ray ray, Shear s, inout RayHit hit) {
    precise vec3 a = turned(triangle.a - ray.origin, s.along_x, s.along_y);
    precise vec3 b = turned(triangle.b - ray.origin, s.along_x, s.along_y);
    precise vec3 c = turned(triangle.c - ray.origin, s.along_x, s.along_y);
    precise vec2 p = a.xy - s.shear.xy * a.z, q = b.xy - s.shear.xy * b.z, r = c.xy - s.shear.xy * c.z;
    precise float u = r.x * q.y - r.y * q.x, v = p.x * r.y - p.y * r.x, w = q.x * p.y - q.y * p.x;
    if (min(u, min(v, w)) < 0.0 && max(u, max(v, w)) > 0.0) return false;
    precise float sum = u + v + w;
    if (sum == 0.0) return false;  // edge-on or degenerate
    precise float t = s.shear.z * (u * a.z + v * b.z + w * c.z) / sum;  // precise: equal in every shader
    if (!(t > ray.least && t < hit.t)) return false;
    vec3 weights = vec3(u, v, w) / sum;
#ifndef RAYS_SOLID
    if (triangle.cutout != NO_CUTOUT && is_hole(rays_cutouts[triangle.cutout], weights, rays_state)) return false;
#endif
    hit.t = t;
    hit.weights = weights;
    return true;
}

// Entry into and exit from the box; entry <= exit if the ray hits it. The factor 1 + 2 gamma(3) bounds three roundings
// (T. Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013).
vec2 span_in_box(BvhNode node, Ray ray, vec3 inverse, float most) {
    vec3 lower = (node.lower - ray.origin) * inverse, upper = (node.upper - ray.origin) * inverse;
    vec3 near = min(lower, upper), far = max(lower, upper);
    return vec2(max(max(near.x, near.y), max(near.z, ray.least)),
                min(min(far.x, far.y), min(far.z, most)) * 1.0000004);
}

// 1 / direction, with a large number instead of infinity, whose product with 0 would be NaN.
vec3 inverse_of(vec3 direction) {
    const float least = 1e-20;
    return 1.0 / mix(direction, vec3(least), lessThan(abs(direction), vec3(least)));
}

// Nearer child first, the other onto a stack. `any`: stops at the first hit.
bool traverse(Ray ray, bool any, out RayHit hit) {
    hit = RayHit(ray.most, 0u, vec3(0.0));
    bool found = false;
    vec3 inverse = inverse_of(ray.direction);
    Shear shear = shear_of(ray.direction);
    uint aside[BVH_STACK], waiting = 0u;
    uint first = rays_nodes[0].first, count = rays_nodes[0].count;
    while (true) {
        for (uint i = first; i < first + count; ++i)
            if (hit_triangle(rays_triangles[i], ray, shear, hit)) {
                hit.triangle = i;
                found = true;
                if (any) return true;
            }
        bool goes_on = false;
        if (count == 0u) {
            BvhNode one = rays_nodes[first], two = rays_nodes[first + 1u];
            vec2 in_one = span_in_box(one, ray, inverse, hit.t), in_two = span_in_box(two, ray, inverse, hit.t);
            bool meets_one = in_one.x <= in_one.y, meets_two = in_two.x <= in_two.y;
            bool takes_one = meets_one && !(meets_two && in_two.x < in_one.x);
            if (meets_one && meets_two) aside[waiting++] = first + uint(takes_one);
            goes_on = meets_one || meets_two;
            first = takes_one ? one.first : two.first;
            count = takes_one ? one.count : two.count;
        }
        if (goes_on) continue;
        if (waiting == 0u) return found;
        uint next = aside[--waiting];
        first = rays_nodes[next].first;
        count = rays_nodes[next].count;
    }
}

bool any_hit(Ray ray) {
    RayHit hit;
    return traverse(ray, true, hit);
}

bool closest_hit(Ray ray, out RayHit hit) { return traverse(ray, false, hit); }
