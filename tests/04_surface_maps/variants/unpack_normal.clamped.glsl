// right
vec3 unpack_normal(vec2 code, float strength) {
    vec2 xy = code * 2.0 - vec2(1.0);
    float z = sqrt(clamp(1.0 - xy.x * xy.x - xy.y * xy.y, 0.0, 1.0));
    vec3 scaled = vec3(xy * strength, z);
    float size = length(scaled);
    return size > 0.0 ? scaled / size : vec3(0.0, 0.0, 1.0);
}
