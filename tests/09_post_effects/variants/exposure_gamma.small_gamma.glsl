// wrong: apply_gamma(
vec3 expose(vec3 radiance, float stops) { return radiance * exp2(stops); }
vec3 apply_gamma(vec3 color, float gamma) { return pow(max(color, 0.0), vec3(1.0 / max(gamma, 1e-3))); }
