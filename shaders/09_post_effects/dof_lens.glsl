// How far out of focus each pixel is.
#include "09_post_effects/circle_of_confusion.glsl"
#include "09_post_effects/dof_now.h"
#include "common/view_rays.h"

layout(scalar) uniform DofBlock { float focus_m, f_number; } dof;
layout(scalar) uniform DofNowBlock { DofNow dof_now; };

// Metres in front of the eye; where nothing was drawn, infinity.
float distance_of(float depth) {
    float inverse = depth_to_per_metre(depth, dof_now.inverse_near, dof_now.inverse_far);
    return depth > 0.0 && inverse > 0.0 ? 1.0 / inverse : uintBitsToFloat(0x7f800000u);
}

// The diameter of the disc in pixels of the whole picture; below 0 in front of the focus.
float confusion(float depth) {
    return circle_of_confusion(distance_of(depth), dof.focus_m, dof_now.focal_m, dof.f_number, dof_now.sensor_m,
                               dof_now.height_px, dof_now.most_px);
}
