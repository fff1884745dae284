// [minimal]
#version 460
// A volume: densities in a box, which shine and hide the background. A ray takes samples. One run for each pixel.
layout(location = 0) in vec3 ray;  // of the pixel
layout(location = 0) out vec4 color;  // light added by the volume, and its opacity
layout(binding = 0) uniform sampler3D densities;  // 0 to 1
layout(push_constant) uniform Frame { vec4 eye; int steps; };  // metres; the box reaches from -1 to 1 on each axis

// Where the ray enters the box and where it leaves it, in metres; if it misses the box, the second is less than the
// first. Two opposite faces are a slab. A direction of 0 along an axis gives infinities of the right sign.
vec2 way_through(vec3 origin, vec3 direction) {
    vec3 lower = (-1.0 - origin) / direction, upper = (1.0 - origin) / direction;
    vec3 enters = min(lower, upper), leaves = max(lower, upper);
    return vec2(max(max(max(enters.x, enters.y), enters.z), 0.0), min(min(leaves.x, leaves.y), leaves.z));
}

// The transfer function: a density's appearance. Colour, and extinction (the share of light that is lost per metre,
// for short ways). Thin matter glows red and is clear, dense matter is bright and opaque.
vec4 classified(float density) {
    return vec4(mix(vec3(0.6, 0.1, 0.05), vec3(1.0, 0.8, 0.5), density), 6.0 * density * density);
}

float density_at(vec3 place) { return textureLod(densities, 0.5 + 0.5 * place, 0.0).r; }

// Light and opacity of the volume along a ray. Of the light that a sample emits, exp(-depth) arrives, where the optical
// depth is the sum of extinction times length in front of it. Each step is read in its middle: the error is smallest.
vec4 march(vec3 origin, vec3 direction, int samples) {
    vec2 way = way_through(origin, direction);
    if (way.y <= way.x) return vec4(0.0);
    float part = (way.y - way.x) / float(samples), depth = 0.0;
    vec3 light = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        vec4 matter = classified(density_at(origin + (way.x + (float(i) + 0.5) * part) * direction));
        float behind = depth + matter.a * part;
        light += matter.rgb * (exp(-depth) - exp(-behind));  // opacity of this step
        depth = behind;
        if (depth > 7.0) break;  // less than 1/1000 of the background can be seen
    }
    return vec4(light, 1.0 - exp(-depth));
}

void main() { color = march(eye.xyz, normalize(ray), steps); }
// [/minimal]
