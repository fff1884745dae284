// The air of a pass, its effect on light at a point, and positions on a path.
#include "10_atmosphere/air_data.h"
#include "10_atmosphere/density.glsl"
#include "10_atmosphere/ray_sphere.glsl"

struct Place {
    float height;
    float sun;  // cosine of the angle between the sun and straight up
};

// Of molecules, dust and the layer, relative to their maximum densities.
vec3 density_at(float height) {
    return density(height, air.rayleigh_height, air.mie_height, air.layer_center, air.layer_width);
}

// Extinction per metre of air.
vec3 extinction(vec3 densities) {
    return air.rayleigh * densities.x + air.mie_extinction * densities.y + air.layer * densities.z;
}

// [height_at]
// The height after `t` metres of a straight way. r² - radius² is taken apart before it is computed: of 6,360 km squared a
// float knows 2,000,000 m².
float height_at(float height, float slope, float t) {
    float k = height * (2.0 * air.radius + height) + t * (2.0 * (air.radius + height) * slope + t);
    return k / (air.radius + sqrt(max(air.radius * air.radius + k, 0.0)));
}
// [/height_at]

#include "10_atmosphere/place_at.glsl"

// The rest of a path from `t` metres on; it begins in the air or at its edge.
Path path_on(Path path, float t) {
    Place place = place_at(path, t);
    float height = clamp(place.height, 0.0, air.top);
    float slope = ((air.radius + path.height) * path.slope + t) / (air.radius + height);
    return Path(height, clamp(slope, -1.0, 1.0), place.sun, path.cos_angle, path.way - t);
}

// The slope of a ray that just touches the ground; from a height of 0 exactly level.
float horizon_slope(float height) {
    height = max(height, 0.0);
    return -sqrt(height * (2.0 * air.radius + height)) / (air.radius + height);
}

// Share of the sun's disc above the planet, 0 to 1, seen from a place in its air.
float sun_share(Place place) {
    float horizon = horizon_slope(place.height);
    // Both are cosines of angles near 90 degrees: their difference is an angle but for the horizon's own dip.
    float dip = max(sqrt(1.0 - horizon * horizon), 1e-3);
    return smoothstep(-air.sun_rad, air.sun_rad, (place.sun - horizon) / dip);
}
