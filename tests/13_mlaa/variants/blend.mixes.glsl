// right
vec3 blend(vec3 own, vec3 left, vec3 right, vec3 above, vec3 below, vec4 weights) {
    vec3 lights[] = vec3[](left, right, above, below);
    float sum = weights.x + weights.y + weights.z + weights.w, scale = 1.0 / max(sum, 1.0);
    vec3 result = sum < 1.0 ? (1.0 - sum) * own : vec3(0.0);
    for (int i = 0; i < 4; ++i)
        if (weights[i] > 0.0) result += weights[i] * scale * lights[i];
    return result;
}
