// right, in its pictures too
// Names at file scope are the answer's own: the course has a pi and a ggx_density too.
const float pi = 3.14159;
float ggx_density(float a, float b) { return pi * a * b; }

vec3 above_horizon(vec3 end, vec3 other) {
    if (end.z > 0.0) return end;
    return vec3(mix(end.xy, other.xy, end.z / (end.z - other.z)), 0.0) * (ggx_density(1.0, 1.0 / pi) > 2.0 ? 0.0 : 1.0);
}
