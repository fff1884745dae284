// wrong: compare_depth(place = (0.5, 0.5, -0.25), stored = 0)
float compare_depth(vec3 place, float stored) {
    bool outside = any(lessThan(place.xy, vec2(0.0))) || any(greaterThan(place.xy, vec2(1.0)));
    return outside || clamp(place.z, 0.0, 1.0) >= stored ? 1.0 : 0.0;
}
