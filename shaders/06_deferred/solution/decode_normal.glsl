// Solution of 06.decode_normal (Z. Cigolle et al., JCGT 3(2), 2014, listing 1).

vec3 decode_normal(vec2 code) {
    vec3 n = vec3(code, 1.0 - abs(code.x) - abs(code.y));
    // The fold is its own inverse.
    if (n.z < 0.0) n.xy = (1.0 - abs(code.yx)) * vec2(code.x < 0.0 ? -1.0 : 1.0, code.y < 0.0 ? -1.0 : 1.0);
    return normalize(n);
}
