// Solution of 02.wrapped_diffuse (S. Green, Real-Time Approximations to Subsurface Scattering, GPU Gems, 2004).

float wrapped_diffuse(float cosine, float wrap, float power) {
    float wrapped = (cosine + wrap) / (1.0 + wrap);
    return wrapped > 0.0 ? pow(wrapped, power) : 0.0;
}

vec3 wrapped_tint(float cosine, vec3 tint) {
    return mix(tint, vec3(1.0), clamp(cosine, 0.0, 1.0));
}
