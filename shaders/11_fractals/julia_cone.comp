// The pre-pass: one cone around all rays of a tile, as far as it is empty.
#include "11_fractals/julia.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) writeonly uniform image2D starts;

void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile, imageSize(starts)))) return;
    ViewRays rays = julia_now.rays;
    vec3 axis = ray_through(rays, (vec2(tile) + 0.5) * float(julia_now.tile));
    // To the tile's corners: no ray of it is farther from the axis than this at 1 m.
    float spread = 0.5 * float(julia_now.tile) * length(rays.right + rays.down) / length(axis);
    march_from = rays.eye;
    march_along = normalize(axis);

    float t = max(length(rays.eye) - julia_now.bound, 0.0);
    float end = length(rays.eye) + julia_now.bound;
    int steps = 0;
    // [cone]
    while (steps < julia.most_steps && t < end) {
        ++steps;
        // The sphere around the axis at t holds the cone up to t + advance, where the cone is spread (t + advance) wide.
        float advance = (distance_at(t) - spread * t) / (1.0 + spread);
        if (advance < 0.25 * spread * t + 1e-4) break;
        t += advance;
    }
    // [/cone]
    imageStore(starts, tile, vec4(t, float(steps), 0.0, 0.0));
}
