// right
float one(float x) { return x < 0.0 ? -1.0 : 1.0; }
vec2 encode_normal(vec3 normal) {
    vec3 n = normal / dot(abs(normal), vec3(1.0));
    vec2 folded = vec2((1.0 - abs(n.y)) * one(n.x), (1.0 - abs(n.x)) * one(n.y));
    return mix(folded, n.xy, float(n.z >= 0.0));
}
