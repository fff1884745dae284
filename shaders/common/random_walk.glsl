// Random numbers and directions of a walk.

// Random numbers for one invocation: M. O'Neill's PCG as M. Jarzynski and M. Olano have it for GPUs (Journal of Computer
// Graphics Techniques 9(3), 2020, p. 21).
uint random_state;

void start_random(uvec2 pixel, uint seed) { random_state = pixel.x * 1973u + pixel.y * 9277u + seed * 26699u + 1u; }

// At least 0, below 1.
float random() {
    random_state = random_state * 747796405u + 2891336453u;
    uint word = ((random_state >> ((random_state >> 28u) + 4u)) ^ random_state) * 277803737u;
    return float(((word >> 22u) ^ word) >> 8u) / 16777216.0;
}

// Another direction, so far from that one.
vec3 turned(vec3 direction, float cosine, float around) {
    vec3 side = normalize(abs(direction.x) < 0.6 ? cross(direction, vec3(1, 0, 0)) : cross(direction, vec3(0, 1, 0)));
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    return normalize(cosine * direction + sine * (cos(around) * side + sin(around) * cross(direction, side)));
}
