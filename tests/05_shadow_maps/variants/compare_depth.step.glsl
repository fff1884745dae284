// right
float compare_depth(vec3 place, float stored) {
    if (place.x < 0.0 || place.x > 1.0 || place.y < 0.0 || place.y > 1.0) return 1.0;
    return step(stored, place.z);
}
