// The shadow of a sphere in the light of a disc.
#include "05_shadow_maps/hidden_share.glsl"

// [sphere_visibility]
// Share of the sun's disc not hidden by the sphere. `sun_rad` is half the angle of the disc. The distance from the
// sphere's edge to the sun's centre is a small difference of two angles that need not be small; the GPU's arc
// functions may be wrong by 4,096 units in the last place (Vulkan specification, Precision and Operation of SPIR-V
// Instructions), more than the whole sun. So: the sine of the difference, from sines and cosines that are ratios of
// lengths.
float sphere_visibility(vec3 to_center, float radius, vec3 to_light, float sun_rad) {
    float away = length(to_center), along = dot(to_center, to_light), across = length(cross(to_center, to_light));
    float to_edge = sqrt(max((away - radius) * (away + radius), 1e-12 * radius * radius));  // where sight touches it
    float away_squared = max(away * away, radius * radius);
    float gap_sine = (across * to_edge - along * radius) / away_squared;
    float gap_cosine = (along * to_edge + across * radius) / away_squared;
    if (gap_cosine <= 0.0) return 1.0;  // on the other side of the sky
    // The sphere's edge is curved like a disc of its tangent as radius.
    float disc = min(radius / (to_edge * sun_rad), 1e6);
    return 1.0 - hidden_share(disc, max(gap_sine / sun_rad, -disc));
}
// [/sphere_visibility]
