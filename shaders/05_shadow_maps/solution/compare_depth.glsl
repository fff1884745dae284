// Solution of 05.compare_depth.

float compare_depth(vec3 place, float stored) {
    bool outside = any(lessThan(place.xy, vec2(0.0))) || any(greaterThan(place.xy, vec2(1.0)));
    return outside || place.z >= stored ? 1.0 : 0.0;  // reverse depth: nearer is greater
}
