// Solution of 13.accumulate.
vec4 accumulate(vec3 fresh, vec3 history, float samples, float most, bool tone) {
    float count = min(samples, max(most - 1.0, 0.0));
    if (count <= 0.0) return vec4(fresh, 1.0);
    float weight = 1.0, old_weight = count;
    if (tone) {
        weight /= 1.0 + fresh.x;
        old_weight /= 1.0 + history.x;
    }
    return vec4((weight * fresh + old_weight * history) / (weight + old_weight), count + 1.0);
}
