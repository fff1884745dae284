// Exercise 03.light_reaches_box: whether a light can reach an object.
// Starter: every object is lit by every light: the picture is right, and nothing is saved.
#include "03_attenuation/exercises.h"

namespace lightwalk::exercise {

// [light_reaches_box]
// True if a light may illuminate something in `box` (world space, not empty); never false
// if it does. `radius_m`, 0 or more, is the distance at which the light ends. A directional
// light always reaches the box. Any other light of radius 0 never does. A point light
// reaches the box if the box's nearest point lies within the radius. A spot light must in
// addition have a cone, of half angle outer_rad (0 to pi), that meets the bounding sphere
// of the box. The test may keep lights that miss by up to a thousandth of the radius.
// [/light_reaches_box]
bool light_reaches_box(const Light& light, float radius_m, const Bounds& box) {
    // The box's point nearest to a point p is p clamped to the box (glm::clamp takes vectors).
    // For a spot light think in the plane through the cone's axis and the middle of the ball around the box: how far is
    // the middle from the cone's side? Which point of the cone is nearest where the box lies behind the apex?
    (void)light, (void)radius_m, (void)box;
    return true;
}

}  // namespace lightwalk::exercise
