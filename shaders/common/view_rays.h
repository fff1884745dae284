// The rays through a picture's pixels, for passes that draw no triangles.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// Made on the processor in double precision: far from the origin a matrix' inverse loses what tells two pixels apart.
struct ViewRays {
    vec3 eye;                         // metres, world space
    vec3 corner;                      // through the picture's upper left corner; along the view its length is 1
    vec3 right, down;                 // to the next pixel
    float inverse_near, inverse_far;  // 1/m; inverse_far is 0 where the far plane is at infinity
};

// Through a place in the picture, in pixels from its upper left corner; along the view its length is 1.
SHARED_FUNCTION vec3 ray_through(ViewRays rays, vec2 pixel) {
    return rays.corner + pixel.x * rays.right + pixel.y * rays.down;
}

// How far away, in metres along the view, what a depth buffer stores is; it is above 0.
SHARED_FUNCTION float distance_along_view(ViewRays rays, float depth) {
    return 1.0f / (rays.inverse_far + depth * (rays.inverse_near - rays.inverse_far));
}

END_SHARED
