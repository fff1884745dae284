// right
vec3 transmittance(float thickness_mm) {
    float s = thickness_mm > 0.0 ? thickness_mm : 0.0, s2 = -s * s;
    return vec3(0.233, 0.455, 0.649) * exp(s2 / 0.0064) + vec3(0.1, 0.336, 0.344) * exp(s2 / 0.0484) +
           vec3(0.118, 0.198, 0.0) * exp(s2 / 0.187) + vec3(0.113, 0.007, 0.007) * exp(s2 / 0.567) +
           vec3(0.358, 0.004, 0.0) * exp(s2 / 1.99) + vec3(0.078, 0.0, 0.0) * exp(s2 / 7.41);
}
