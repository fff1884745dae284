// [minimal]
#version 460
// A picture of the surroundings as a light for matt surfaces: nine colours (left) hold nearly all that the sum over
// every direction (right) does (R. Ramamoorthi and P. Hanrahan, SIGGRAPH 2001).
layout(location = 0) in vec3 ray;  // of the pixel; y points up
layout(location = 1) in vec2 uv;  // 0 to 1 over the picture
layout(location = 0) out vec4 color;  // linear light
layout(push_constant) uniform Frame { vec4 eye; float divider; };
const float pi = 3.14159265, directions = 400.0, window = 8.0, exposure = 0.5, albedo = 0.6;

// The radiance that arrives from a direction: sky, ground, and a bright window.
vec3 radiance(vec3 from) {
    vec3 sky = from.y > 0.0 ? vec3(0.4, 0.6, 1.0) : vec3(0.25, 0.2, 0.15);
    return sky + window * vec3(1.0, 0.9, 0.7) * float(dot(from, normalize(vec3(1.0, 0.7, 0.2))) > 0.94);
}

// The k-th of the spherical harmonics up to the second order, without their factors.
float basis(int k, vec3 d) {
    float two[5] = float[5](d.x * d.y, d.y * d.z, d.x * d.z, d.x * d.x - d.y * d.y, 3.0 * d.z * d.z - 1.0);
    return k == 0 ? 1.0 : k < 4 ? vec3(d.y, d.z, d.x)[k - 1] : two[k - 4];
}
// The factors, squared (1 / 4 pi for the first), times the cosine's own for each order: pi, 2 pi / 3, pi / 4.
const float weights[9] = float[9](0.25, 0.5, 0.5, 0.5, 0.9375, 0.9375, 0.9375, 0.234375, 0.078125);

// The i-th of n directions that are spread evenly over the sphere: each stands for 4 pi / n of solid angle.
vec3 direction(int i, int n) {
    float y = 1.0 - (2.0 * float(i) + 1.0) / float(n), r = sqrt(1.0 - y * y);
    // The golden angle, in turns; of 1000 of them only the part behind the whole turns.
    float turn = 2.0 * pi * fract(0.38196601 * float(i % 1000) + 0.9660113 * float(i / 1000));
    return vec3(r * cos(turn), y, r * sin(turn));
}

// The coefficients of the picture, and with them the irradiance on a surface.
vec3 irradiance(vec3 normal, int n) {
    vec3 colors[9], sum = vec3(0.0);
    for (int k = 0; k < 9; ++k) colors[k] = vec3(0.0);
    for (int i = 0; i < n; ++i) {
        vec3 from = direction(i, n), light = radiance(from) * 4.0 * pi / float(n);
        for (int k = 0; k < 9; ++k) colors[k] += light * basis(k, from);
    }
    for (int k = 0; k < 9; ++k) sum += weights[k] * basis(k, normal) * colors[k];
    return max(sum, vec3(0.0));
}
// The reference: a cosine-weighted sum over all directions.
vec3 exact(vec3 normal, int n) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < n; ++i) sum += radiance(direction(i, n)) * max(dot(normal, direction(i, n)), 0.0);
    return sum * 4.0 * pi / float(n);
}

void main() {
    vec3 seen = normalize(ray);
    float near = -dot(eye.xyz, seen), half_squared = 1.0 - dot(eye.xyz, eye.xyz) + near * near;
    color = vec4(exposure * radiance(seen), 1.0);
    if (half_squared < 0.0 || near < 0.0) return;
    vec3 normal = eye.xyz + (near - sqrt(half_squared)) * seen;
    vec3 arriving = uv.x < divider ? irradiance(normal, int(directions)) : exact(normal, int(directions));
    color.rgb = exposure * albedo / pi * arriving;
}
// [/minimal]
