// Shadow of a sphere under a disc light.
#include "05_shadow_maps/hidden_share.glsl"

// Visible share of the sun's disc beside a sphere; `sun_rad` is the disc's angular radius. The angle between the
// sphere's edge and the sun's centre is a small difference of two angles, and GPU arc functions may err by 4,096 units
// in the last place (Vulkan specification, Precision and Operation of SPIR-V Instructions), more than the whole sun.
// Hence the sine of the difference, from sines and cosines that are ratios of lengths.
float sphere_visibility(vec3 to_center, float radius, vec3 to_light, float sun_rad) {
    float away = length(to_center), along = dot(to_center, to_light), across = length(cross(to_center, to_light));
    float to_edge = sqrt(max((away - radius) * (away + radius), 1e-12 * radius * radius));  // length of the tangent
    float away_squared = max(away * away, radius * radius);
    float gap_sine = (across * to_edge - along * radius) / away_squared;
    float gap_cosine = (along * to_edge + across * radius) / away_squared;
    if (gap_cosine <= 0.0) return 1.0;  // in the opposite half of the sky
    // The sphere's edge, curved like a disc with its tangent as radius.
    float disc = min(radius / (to_edge * sun_rad), 1e6);
    return 1.0 - hidden_share(disc, max(gap_sine / sun_rad, -disc));
}
