// right, in its pictures too
float terrain_mix(float normal_y, float roughness, vec2 lower, vec2 upper, float strength) {
    float begins = lower.x - lower.y * normal_y, ends = upper.x - upper.y * normal_y, at = strength * roughness;
    if (begins >= ends) return at >= begins ? 1.0 : 0.0;
    float t = clamp((at - begins) / (ends - begins), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}
