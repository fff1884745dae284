// Paths from a place in the world: the ground's highest point is the world's origin, and +y is up there.
#include "10_atmosphere/air.glsl"

// A path to anywhere: its length is up to the caller. Directions have unit length.
Path path_from(vec3 position, vec3 direction, vec3 to_sun) {
    float k = position.y * (2.0 * air.radius + position.y) + dot(position.xz, position.xz);
    float height = k / (air.radius + sqrt(max(air.radius * air.radius + k, 0.0)));
    vec3 up = vec3(position.x, position.y + air.radius, position.z) / (air.radius + height);
    return Path(height, dot(up, direction), dot(up, to_sun), dot(direction, to_sun), 0.0);
}

// How far it is to the ground; below 0: the path does not meet it.
float distance_to_ground(Path path) {
    if (path.height <= 0.0) return path.slope < 0.0 ? 0.0 : -1.0;
    if (path.slope >= horizon_slope(path.height)) return -1.0;
    return max(ray_sphere(path.height, path.slope, air.radius, 0.0).x, 0.0);
}

// Clips the path to a point `distance` away to the air; false: none is left. Moves its start to its entry.
bool clip_to_air(inout Path path, float distance) {
    vec2 shell = ray_sphere(path.height, path.slope, air.radius, air.top);
    if (shell.x > shell.y || shell.y <= 0.0 || shell.x >= distance) return false;
    float enters = max(shell.x, 0.0);
    path.way = min(shell.y, distance);
    path = path_on(path, max(shell.x, 0.0));
    return path.way > 0.0;
}
