// Directions into a photograph of the surroundings, projected on the ground around the origin and on a dome over it.

// `direction` of unit length, from `eye`; the picture was taken `camera_m` above the ground's middle. The ground ends at
// `radius_m`, where the dome begins, so that nothing is sheared: a blend of the ground's direction with the ray's own
// stretched the picture 20 times as much along the horizon as across it.
vec3 projected_direction(vec3 eye, vec3 direction, float ground_y, float camera_m, float radius_m) {
    vec3 camera = vec3(0.0, ground_y + camera_m, 0.0), from = eye - camera;
    float t = direction.y < 0.0 ? (ground_y - eye.y) / direction.y : -1.0;
    vec3 place = eye + t * direction;
    if (t > 0.0 && dot(place.xz, place.xz) <= radius_m * radius_m) return normalize(place - camera);
    float b = dot(from, direction), c = dot(from, from) - radius_m * radius_m - camera_m * camera_m;
    float square = b * b - c;
    if (square <= 0.0) return direction;  // an eye outside of the dome, past it
    return normalize(from + (sqrt(square) - b) * direction);
}
