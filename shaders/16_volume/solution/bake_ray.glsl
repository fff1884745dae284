// Solution of 16.bake_ray: spread over the disc and lifted, directions are as dense as the cosine, and count the same.
vec4 bake_ray(vec2 even) {
    float angle = 6.2831853 * even.y;
    vec2 at = sqrt(even.x) * vec2(cos(angle), sin(angle));
    return vec4(at, sqrt(max(1.0 - dot(at, at), 0.0)), 1.0);
}
