// Solution of 09.exposure_gamma.
vec3 expose(vec3 radiance, float stops) { return exp2(stops) * radiance; }

vec3 apply_gamma(vec3 color, float gamma) {
    if (gamma <= 0.0) return color;
    return pow(max(color, 0.0), vec3(1.0 / gamma));
}
