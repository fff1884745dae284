// Rays through a bounding-volume hierarchy: the module SceneRays for shaders.
#include "04_surface_maps/cutout.glsl"
#include "05_shadow_maps/bvh_data.h"
#include "common/structs.h"

layout(scalar) readonly buffer RayNodeBuffer { BvhNode rays_nodes[]; };
layout(scalar) readonly buffer RayTriangleBuffer { RayTriangle rays_triangles[]; };
layout(scalar) uniform RayStateBlock { RayState rays_state; };

const float on_and_on = 1e13;

// Rays begin a little above the surface, so that it does not shadow itself. `facing` is the normal of the mesh.
vec3 above(vec3 position, vec3 facing) { return position + rays_state.offset_m * facing; }

// Cut-outs of triangles met by rays: chapter 04's rule over textures kept as numbers, for a ray may meet any of the
// scene's textures.
#ifndef RAYS_SOLID
layout(scalar) readonly buffer RayCutoutBuffer { RayCutout rays_cutouts[]; };
layout(scalar) readonly buffer RayMaskBuffer { RayMask rays_masks[]; };
layout(scalar) readonly buffer RayTexelBuffer { uint rays_texels[]; };

float mask_texel(RayMask mask, ivec2 at) {
    uint texel = uint(at.y) * mask.width + uint(at.x);
    return float(rays_texels[mask.first + texel / 4u] >> 8u * (texel % 4u) & 255u) / 255.0;
}

// [mask_at]
// Bilinear and repeating, as a sampler reads level 0. v = 0 is the bottom row.
float mask_at(RayMask mask, vec2 uv) {
    ivec2 size = ivec2(mask.width, mask.height);
    vec2 at = fract(vec2(uv.x, 1.0 - uv.y)) * vec2(size) - 0.5;
    ivec2 low = ivec2(floor(at));
    vec2 part = at - vec2(low);
    ivec2 from = (low + size) % size, to = (low + 1) % size;
    return mix(mix(mask_texel(mask, from), mask_texel(mask, ivec2(to.x, from.y)), part.x),
               mix(mask_texel(mask, ivec2(from.x, to.y)), mask_texel(mask, to), part.x), part.y);
}
// [/mask_at]

// The first mask cuts nothing.
bool is_hole(RayCutout cutout, vec3 weights, RayState now) {
    vec2 uv = weights.x * cutout.a + weights.y * cutout.b + weights.z * cutout.c;
    uv = moving_uv(uv, now.wobble, now.scroll, now.time_s);
    float color_alpha = mask_at(rays_masks[now.color_cuts * cutout.color_mask], uv);
    float opacity = mask_at(rays_masks[now.opacity_cuts * cutout.opacity_mask], uv);
    return is_cut_out(surface_alpha(color_alpha, opacity, 1.0), cutout.cutoff < 0.0 ? now.cutoff : cutout.cutoff);
}
#endif

// Goes from `least` to `most` times its direction, which has any length but 0.
struct Ray {
    vec3 origin;  // metres, world space
    float least;
    vec3 direction;
    float most;
};

struct RayHit {
    float t;        // in lengths of the ray's direction
    uint triangle;  // in rays_triangles
    vec3 weights;   // of its corners: barycentric coordinates
};

// [shear]
// S. Woop, C. Benthin and I. Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: moved and sheared so that the
// ray goes along an axis through 0, whether it meets a triangle is asked in two dimensions.
struct Shear {
    bool along_x, along_y;  // the axis along which the ray goes fastest; neither: z
    vec3 shear;
};

// The axes turned so that the fastest is the last.
vec3 turned(vec3 v, bool along_x, bool along_y) { return along_x ? v.yzx : along_y ? v.zxy : v; }

Shear shear_of(vec3 direction) {
    vec3 size = abs(direction);
    bool along_x = size.x >= size.y && size.x >= size.z, along_y = !along_x && size.y >= size.z;
    vec3 d = turned(direction, along_x, along_y);
    return Shear(along_x, along_y, vec3(d.xy, 1.0) / d.z);
}
// [/shear]

// [hit_triangle]
// Each edge's sign is that of a difference of two products. Rounding keeps order: it can make a difference 0 and never
// turn its sign; and two triangles get the same number, with opposite signs, for the edge they share. So with 0 counted
// as inside no ray passes between them, without the paper's second try in double precision. That needs the sums exactly
// as they are written: `precise`.
bool hit_triangle(RayTriangle triangle, Ray ray, Shear s, inout RayHit hit) {
    precise vec3 a = turned(triangle.a - ray.origin, s.along_x, s.along_y);
    precise vec3 b = turned(triangle.b - ray.origin, s.along_x, s.along_y);
    precise vec3 c = turned(triangle.c - ray.origin, s.along_x, s.along_y);
    precise vec2 p = a.xy - s.shear.xy * a.z, q = b.xy - s.shear.xy * b.z, r = c.xy - s.shear.xy * c.z;
    precise float u = r.x * q.y - r.y * q.x, v = p.x * r.y - p.y * r.x, w = q.x * p.y - q.y * p.x;
    if (min(u, min(v, w)) < 0.0 && max(u, max(v, w)) > 0.0) return false;
    precise float sum = u + v + w;
    if (sum == 0.0) return false;  // seen from the side, or of no area
    precise float t = s.shear.z * (u * a.z + v * b.z + w * c.z) / sum;  // the same in every shader
    if (!(t > ray.least && t < hit.t)) return false;
    vec3 weights = vec3(u, v, w) / sum;
#ifndef RAYS_SOLID
    if (triangle.cutout != NO_CUTOUT && is_hole(rays_cutouts[triangle.cutout], weights, rays_state)) return false;
#endif
    hit.t = t;
    hit.weights = weights;
    return true;
}
// [/hit_triangle]

// [box]
// The ray's entry into the box and its exit: in that order if it meets the box. The factor is 1 + 2 gamma(3), the
// bound on three roundings (T. Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013).
vec2 span_in_box(BvhNode node, Ray ray, vec3 inverse, float most) {
    vec3 lower = (node.lower - ray.origin) * inverse, upper = (node.upper - ray.origin) * inverse;
    vec3 near = min(lower, upper), far = max(lower, upper);
    return vec2(max(max(near.x, near.y), max(near.z, ray.least)),
                min(min(far.x, far.y), min(far.z, most)) * 1.0000004);
}

// 1 / direction; along an axis orthogonal to the ray a large number instead of infinity, to avoid NaN as its product
// with 0.
vec3 inverse_of(vec3 direction) {
    const float least = 1e-20;
    return 1.0 / mix(direction, vec3(least), lessThan(abs(direction), vec3(least)));
}
// [/box]

// [traverse]
// The nearer child first; the other is put aside. `any`: the first triangle met ends it.
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
// [/traverse]

bool any_hit(Ray ray) {
    RayHit hit;
    return traverse(ray, true, hit);
}

bool closest_hit(Ray ray, out RayHit hit) { return traverse(ray, false, hit); }
