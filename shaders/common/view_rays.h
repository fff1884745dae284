// Rays through pixels, for passes without triangles.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// Computed in double precision on the CPU: far from the origin an inverse float matrix cannot separate neighbouring
// pixels.
struct ViewRays {
    vec3 eye;                         // metres, world space
    vec3 corner;                      // ray through the upper left corner; length 1 along the view
    vec3 right, down;                 // step to the next pixel
    float inverse_near, inverse_far;  // 1/m; inverse_far is 0 where the far plane is at infinity
};

// Ray through a point in pixels from the upper left corner; length 1 along the view.
SHARED_FUNCTION vec3 ray_through(ViewRays rays, vec2 pixel) {
    return rays.corner + pixel.x * rays.right + pixel.y * rays.down;
}

// Reciprocal distance along the view, per metre. Stored depth is linear in it: 1 at the near plane, 0 at the far one.
SHARED_FUNCTION float depth_to_per_metre(float depth, float inverse_near, float inverse_far) {
    return inverse_far + depth * (inverse_near - inverse_far);
}

// Distance along the view, in metres, of a stored depth above 0.
SHARED_FUNCTION float depth_to_metres(float depth, float inverse_near, float inverse_far) {
    return 1.0f / depth_to_per_metre(depth, inverse_near, inverse_far);
}
SHARED_FUNCTION float distance_along_view(ViewRays rays, float depth) {
    return depth_to_metres(depth, rays.inverse_near, rays.inverse_far);
}

END_SHARED
