// [minimal]
#version 460
// A landscape that is nothing but arithmetic: octaves of noise, a ray that looks for them, sunlight and shadow. Metres.
layout(location = 0) in vec3 ray;  // of the pixel; y points up
layout(location = 0) out vec4 color;
layout(push_constant) uniform Frame { vec4 eye, to_sun; };
const float highest_m = 900.0, cell_m = 1500.0;  // no ground above; the size of the largest hills
// A random number, 0 to 1, for a lattice point: by integers, which keep all of their digits anywhere.
float lattice(ivec2 cell) {
    uvec2 v = uvec2(cell) * 1664525u + 1013904223u;
    v += v.yx * 1664525u;
    v ^= v >> 16u;
    v += v.yx * 1664525u;
    return float((v.x ^ (v.x >> 16u)) >> 8u) / 16777216.0;
}

// Value noise: the numbers of a cell's corners, mixed so that neither edges nor corners show.
float noise(vec2 at) {
    ivec2 cell = ivec2(floor(at));
    vec2 s = smoothstep(0.0, 1.0, fract(at));
    return mix(mix(lattice(cell), lattice(cell + ivec2(1, 0)), s.x),
               mix(lattice(cell + ivec2(0, 1)), lattice(cell + ivec2(1, 1)), s.x), s.y);
}

// A fractal: each octave has half the height and half the width of the one before. It is turned as well, by 37°, so
// that the cells of the octaves do not lie upon each other.
float ground(vec2 at, int octaves) {
    float sum = 0.0, height = 0.5;
    for (int i = 0; i < octaves; ++i, height *= 0.5, at = mat2(1.6, 1.2, -1.2, 1.6) * at)
        sum += height * noise(at / cell_m);
    return highest_m * sum;
}

// Where a ray meets the ground, in metres along it; `far` where it does not. A step is a share of the height over the
// ground: long where nothing is near. The first place below the ground and the one before it give the crossing.
float march(vec3 origin, vec3 direction, float far, int octaves) {
    float before = 0.0, above = 1.0, t = 1.0;
    for (int i = 0; i < 400 && t < far; ++i) {
        vec3 place = origin + t * direction;
        float height = place.y - ground(place.xz, octaves);
        if (height < 0.0) return mix(before, t, above / (above - height));
        if (direction.y > 0.0 && place.y > highest_m) break;
        before = t, above = height;
        t += max(0.25 * height, 0.0005 * t);
    }
    return far;
}

void main() {
    vec3 direction = normalize(ray), place = eye.xyz, sky = vec3(0.5, 0.6, 0.8);
    float t = march(place, direction, 20000.0, 9), e = 0.001 * t;
    place += t * direction;
    // The slope over the width of a pixel: finer ones would only be noise.
    vec3 normal = normalize(vec3(ground(place.xz - vec2(e, 0.0), 9) - ground(place.xz + vec2(e, 0.0), 9), 2.0 * e,
                                 ground(place.xz - vec2(0.0, e), 9) - ground(place.xz + vec2(0.0, e), 9)));
    bool lit = march(place + 2.0 * normal, to_sun.xyz, 8000.0, 6) >= 8000.0;  // shadows need fewer octaves
    vec3 light = vec3(0.3, 0.25, 0.2) * (float(lit) * max(dot(normal, to_sun.xyz), 0.0) + 0.15);
    color = vec4(t < 20000.0 ? mix(sky, light, exp(-t / 8000.0)) : sky, 1.0);  // the air between takes and gives light
}
// [/minimal]
