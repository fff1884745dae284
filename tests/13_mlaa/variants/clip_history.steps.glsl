// right
vec3 clip_history(vec3 history, vec3 lowest, vec3 highest) {
    vec3 middle = 0.5 * (lowest + highest), reach = max(0.5 * (highest - lowest), vec3(1e-9));
    vec3 units = abs(history - middle) / reach;
    float worst = max(units.x, max(units.y, units.z));
    return worst > 1.0 ? middle + (history - middle) / worst : history;
}
