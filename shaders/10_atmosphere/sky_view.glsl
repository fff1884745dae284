// The table of the sky: light inscattered towards the eye from each direction above the horizon. None below it: light
// hidden by the ground is never mixed into the sky's edge. Across: the angle around straight up, from the sun's, 0 to
// pi; down: from the horizon (0) to the zenith (1), closer at the horizon.
#include "10_atmosphere/air.glsl"

const float pi = 3.14159265;

// Elevation in radians for a slope.
float elevation_of(float slope) { return asin(clamp(slope, -1.0, 1.0)); }

// How far the horizon lies below level, as an elevation; 0 or less.
float horizon_elevation(float height) { return -atan(sqrt(max(height * (2.0 * air.radius + height), 0.0)) / air.radius); }

vec2 sky_at(float elevation, float around, float height) {
    float horizon = horizon_elevation(height);
    return vec2(around / pi, sqrt(clamp((elevation - horizon) / (0.5 * pi - horizon), 0.0, 1.0)));
}

// (elevation, angle around) at a place in the table.
vec2 sky_direction(vec2 at, float height) {
    float horizon = horizon_elevation(height);
    return vec2(horizon + at.y * at.y * (0.5 * pi - horizon), at.x * pi);
}
