// [minimal]
#version 460
// A Julia set of quaternions: the points that z = z² + c never drives away, found by steps of a safe length.
layout(location = 0) in vec3 ray;  // of the pixel; y points up
layout(location = 0) out vec4 color;
layout(push_constant) uniform Frame { vec4 eye, to_sun, c; };
const float escape = 4.0, closest = 0.001;

// The product of two quaternions; their order matters.
vec4 times(vec4 a, vec4 b) {
    return vec4(a.x * b.x - dot(a.yzw, b.yzw), a.x * b.yzw + b.x * a.yzw + cross(a.yzw, b.yzw));
}

// A lower bound of the distance from a point to the set (J. Hart et al., 1989): |z'| grows with each step by 2 |z|.
float distance_at(vec3 place) {
    vec4 z = vec4(place, 0.0);
    float slope = 1.0;
    for (int i = 0; i < 40 && dot(z, z) < escape * escape; ++i) {
        slope *= 2.0 * length(z);
        z = times(z, z) + c;
    }
    float square = dot(z, z);
    return square < escape * escape ? 0.0 : 0.25 * sqrt(square) / max(slope, 1e-12) * log(square);
}

float march(vec3 from, vec3 direction, float far) {
    float t = 0.0;
    for (int i = 0; i < 160 && t < far; ++i) {
        float step_m = distance_at(from + t * direction);
        if (step_m < closest) return t;
        t += step_m;
    }
    return far;
}

void main() {
    vec3 direction = normalize(ray);
    float middle = -dot(eye.xyz, direction), beside = dot(eye.xyz, eye.xyz) - middle * middle;
    color = vec4(mix(vec3(0.02, 0.03, 0.05), vec3(0.10, 0.13, 0.18), 0.5 + 0.5 * direction.y), 1.0);
    if (beside > 4.0) return;  // the set lies in a ball of radius 2
    float half_chord = sqrt(4.0 - beside), enters = max(middle - half_chord, 0.0);
    float t = enters + march(eye.xyz + enters * direction, direction, 2.0 * half_chord);
    if (t >= enters + 2.0 * half_chord) return;
    vec3 place = eye.xyz + t * direction, e = vec3(0.002, -0.002, 0.0);
    vec3 normal = normalize(e.xyy * distance_at(place + e.xyy) + e.yyx * distance_at(place + e.yyx) +
                            e.yxy * distance_at(place + e.yxy) + e.xxx * distance_at(place + e.xxx) + vec3(1e-12));
    float lit = march(place + 0.01 * normal, to_sun.xyz, 3.0) < 3.0 ? 0.0 : max(dot(normal, to_sun.xyz), 0.0);
    vec3 stone = mix(vec3(0.75, 0.35, 0.15), vec3(0.25, 0.45, 0.65), 0.5 + 0.5 * normal.y);
    color.rgb = stone * (1.3 * lit + 0.12 + 0.12 * normal.y);
}
// [/minimal]
