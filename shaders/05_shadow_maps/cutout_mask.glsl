// What is cut out of the triangles that rays meet: chapter 04's rule over textures kept as numbers, for a ray may meet
// any of the scene's textures.
#include "04_surface_maps/cutout.glsl"
#include "05_shadow_maps/bvh_data.h"

#if RAYS_CUTOUTS
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

bool is_hole(RayCutout cutout, vec3 weights, float cutoff) {
    vec2 uv = weights.x * cutout.a + weights.y * cutout.b + weights.z * cutout.c;
    float color_alpha = mask_at(rays_masks[cutout.color_mask], uv), opacity = mask_at(rays_masks[cutout.opacity_mask], uv);
    return is_cut_out(surface_alpha(color_alpha, opacity, 1.0), cutoff);
}
#endif
