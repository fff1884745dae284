// Solution of 04.above_horizon.
vec3 above_horizon(vec3 end, vec3 other) {
    return end.z > 0.0 ? end : vec3(mix(end.xy, other.xy, end.z / (end.z - other.z)), 0.0);
}
