// What both passes of the occlusion of what is seen are given, and the surface in a pixel.
#include "common/view_rays.h"

layout(scalar) uniform OcclusionStepBlock {
    ViewRays rays;
    vec2 shrink;
    float pixels_per_rad;
    float radius_m, thickness;
    int slices, steps;
} occlusion_step;
uniform sampler2D depth;

float stored_at(ivec2 pixel) { return texelFetch(depth, clamp(pixel, ivec2(0), textureSize(depth, 0) - 1), 0).r; }

// Of the middle of a pixel, from the eye on: metres, along world axes.
vec3 place_of(ivec2 pixel, float stored) {
    ivec2 inside = clamp(pixel, ivec2(0), textureSize(depth, 0) - 1);
    return ray_through(occlusion_step.rays, vec2(inside) + 0.5) * distance_along_view(occlusion_step.rays, stored);
}
