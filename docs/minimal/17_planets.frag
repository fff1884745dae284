// [minimal]
#version 460
// A flattened planet in its rings, with the shadow of each on the other. One run for each pixel.
layout(location = 0) in vec3 ray;     // of the pixel; the planet's axes, +y its north pole
layout(location = 0) out vec4 color;  // linear light; 1 is a white surface that faces the sun
layout(push_constant) uniform Frame { vec4 eye; vec4 to_sun; };  // radii of the equator, from the planet's centre
const float flattening = 0.098, ring_inner = 1.24, ring_outer = 2.27;  // Saturn's

// Stretched along its axis the planet is a ball of radius 1, and lines stay lines.
vec3 stretched(vec3 v) { return vec3(v.x, v.y / (1.0 - flattening), v.z); }

// Distance to the planet along the direction; below 0 if it is not ahead. The ray's nearest point to the centre comes
// first, since far away the difference of two large squares would lose all digits.
float planet_distance(vec3 from, vec3 direction) {
    vec3 o = stretched(from), d = stretched(direction);
    float nearest = -dot(o, d) / dot(d, d), apart = length(o + nearest * d);
    if (apart >= 1.0) return -1.0;
    return nearest - sqrt((1.0 - apart) * (1.0 + apart) / dot(d, d));
}

// Optical depth along the rings' normal: of C, B, Cassini's division and A.
float optical_depth(float radius) {
    if (radius < ring_inner || radius > ring_outer) return 0.0;
    return radius < 1.53 ? 0.1 : radius < 1.95 ? 1.8 : radius < 2.03 ? 0.1 : 0.5;
}

// Light of a layer of particles after one scattering (S. Chandrasekhar, 1950), seen from the lit side or from the
// other one. `mu0` and `mu` are the cosines of the sun's and the eye's angle to the normal.
float ring_light(float depth, float mu0, float mu, bool lit) {
    if (lit) return 0.25 * mu0 / (mu0 + mu) * (1.0 - exp(-depth / mu - depth / mu0));
    float a = depth / mu0, b = depth / mu, x = abs(a - b);
    return 0.25 * b * exp(-min(a, b)) * (x < 0.02 ? 1.0 - 0.5 * x : (1.0 - exp(-x)) / x);
}

// Transmittance of the rings between a place and the sun.
float ring_shadow(vec3 at, vec3 sun) {
    float t = abs(sun.y) > 1e-6 ? -at.y / sun.y : -1.0;
    return t > 0.0 ? exp(-optical_depth(length(at.xz + t * sun.xz)) / abs(sun.y)) : 1.0;
}

void main() {
    vec3 direction = normalize(ray), sun = to_sun.xyz;
    float t = planet_distance(eye.xyz, direction), rings = -eye.y / direction.y;
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (t > 0.0) {
        vec3 at = eye.xyz + t * direction, normal = normalize(stretched(stretched(at)));  // the gradient
        float mu0 = max(dot(normal, sun), 0.0), mu = max(dot(normal, -direction), 0.04);
        color.rgb = vec3(0.8, 0.68, 0.46) * pow(mu0, 0.9) * pow(mu, -0.1) * ring_shadow(at, sun);  // M. Minnaert, 1941
    }
    vec3 at = eye.xyz + rings * direction;
    float depth = optical_depth(length(at.xz)), mu = abs(direction.y), mu0 = abs(sun.y);
    if (rings <= 0.0 || depth == 0.0 || (t > 0.0 && t < rings)) return;
    float seen = planet_distance(at, sun) > 0.0 ? 0.0 : ring_light(depth, mu0, mu, (sun.y > 0.0) == (eye.y > 0.0));
    color.rgb = exp(-depth / mu) * color.rgb + 2.5 * vec3(0.9, 0.82, 0.7) * seen;  // ice sends light back: 2.5
}
// [/minimal]
