// wrong: blend(
vec3 share_of(vec3 light, float weight) { return weight > 0.0 ? weight * light : vec3(0.0); }

vec3 blend(vec3 own, vec3 left, vec3 right, vec3 above, vec3 below, vec4 weights) {
    float sum = weights.x + weights.y + weights.z + weights.w;
    weights /= sum;
    return share_of(own, 1.0 - min(sum, 1.0)) + share_of(left, weights.x) + share_of(right, weights.y) +
           share_of(above, weights.z) + share_of(below, weights.w);
}
