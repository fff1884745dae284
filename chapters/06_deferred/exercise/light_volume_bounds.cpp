// Exercise 06.light_volume_bounds: what has to be drawn so that a light meets all it may light.
// As it stands every light is drawn as a huge ball: the picture is right, and nothing is saved.
#include "06_deferred/exercises.h"

namespace lightwalk::exercise {

// [light_volume_bounds]
// A point or spot light that reaches `radius_m` far (0 or more): which unit shape, and the matrix that makes it hold
// every point that the light may reach, and little else. A point light reaches a ball. A spot light reaches the part of
// that ball within its cone, whose half angle is outer_rad (0 to pi) around `direction` (unit length): draw the cone
// whose base lies at the ball's far end, or the ball, whichever has the smaller volume. A thousandth more than needed
// is allowed.
// [/light_volume_bounds]
LightVolume light_volume_bounds(const Light& light, float radius_m) {
    // A matrix is four columns: where x, y and z go, and where the origin goes. The cone's axis is z. How wide is its
    // base, at a distance of radius_m from the apex? And what becomes of that at 90 degrees, and beyond?
    // A ball has the volume 4/3 pi r^3, a cone 1/3 pi (radius of the base)^2 times its height.
    LightVolume volume;
    volume.to_world = glm::mat4(1000.0f + radius_m);
    volume.to_world[3] = glm::vec4(light.position, 1.0f);
    return volume;
}

}  // namespace lightwalk::exercise
