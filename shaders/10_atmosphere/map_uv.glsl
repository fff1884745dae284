// Longitude and latitude of a direction of unit length, as coordinates on the map of a planet: equirectangular, north up, the
// prime meridian in the middle.
vec2 map_uv(vec3 direction) {
    return vec2(0.5 + atan(direction.x, direction.z) / 6.2831853, 0.5 - asin(clamp(direction.y, -1.0, 1.0)) / 3.14159265);
}
