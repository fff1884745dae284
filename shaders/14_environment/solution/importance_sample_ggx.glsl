// Solution of 14.importance_sample_ggx.
// B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, equations 35 and 36.
vec3 importance_sample_ggx(vec2 random, float alpha) {
    float phi = 2.0 * 3.14159265358979 * random.x;
    float cosine_square = (1.0 - random.y) / (1.0 + (alpha * alpha - 1.0) * random.y);
    float sine = sqrt(max(1.0 - cosine_square, 0.0));
    return vec3(sine * cos(phi), sine * sin(phi), sqrt(cosine_square));
}
