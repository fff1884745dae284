// Exercise 06.light_volume_bounds: the shape to draw for a light.
// Starter: every light is drawn as a huge sphere: the picture is right, and nothing is saved.
#include "06_deferred/exercises.h"

namespace lightwalk::exercise {

// [light_volume_bounds]
// The unit shape to draw for a point or spot light, and the matrix that makes it contain
// every point that the light may reach, and little else. The light ends at the distance
// `radius_m`, 0 or more. The unit sphere has its centre at the origin and radius 1; the
// unit cone has its apex at the origin and a base of radius 1 at z = 1. A point light
// reaches a sphere. A spot light reaches the part of that sphere within its cone, of half
// angle outer_rad (0 to pi) around `direction` (a unit vector): draw the cone whose base
// lies at the distance radius_m, or the sphere, whichever has the smaller volume. The shape
// may be a thousandth larger than needed.
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
