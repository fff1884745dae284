// wrong: compare_depth(place = (0.5, 0.5, -0.25), stored = 0.5)
float compare_depth(vec3 place, float stored) {
    bool outside = any(lessThan(place, vec3(0.0))) || any(greaterThan(place, vec3(1.0)));
    return outside || place.z >= stored ? 1.0 : 0.0;
}
