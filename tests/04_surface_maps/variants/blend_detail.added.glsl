// wrong: blend_detail(
vec3 blend_detail(vec3 base, vec3 detail) {
    return normalize(vec3(base.xy + detail.xy, base.z));
}
