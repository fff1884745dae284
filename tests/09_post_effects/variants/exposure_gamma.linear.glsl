// wrong: expose(
vec3 expose(vec3 radiance, float stops) { return radiance * (1.0 + stops); }
vec3 apply_gamma(vec3 color, float gamma) { return gamma <= 0.0 ? color : pow(max(color, 0.0), vec3(1.0 / gamma)); }
