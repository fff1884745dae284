// Longitude and latitude of a direction of unit length, as coordinates on the map of a planet: equirectangular, north up, the
// prime meridian in the middle. Latitude by atan: a device's asin may be off by a quarter of a texel of 2048 rows.
vec2 map_uv(vec3 direction) {
    return vec2(0.5 + atan(direction.x, direction.z) / 6.2831853, 0.5 - atan(direction.y, length(direction.xz)) / 3.14159265);
}
