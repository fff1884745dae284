// wrong: terrain_mix(

float terrain_mix(float normal_y, float roughness, vec2 lower, vec2 upper, float strength) {
    float begins = lower.x - lower.y * normal_y, ends = upper.x - upper.y * normal_y, at = roughness;
    if (begins >= ends) return at >= begins ? 1.0 : 0.0;
    return smoothstep(begins, ends, at);
}
