// Surroundings of the shell: a dark hall with strips of light above and a warm glow below. An environment cube can
// replace this function.

vec3 surroundings(vec3 direction) {
    float height = direction.y;
    float around = atan(direction.z, direction.x);
    // Twelve lamps in a ring under the ceiling, and the floor's reflection of them.
    float lamp = smoothstep(0.75, 0.95, cos(6.0 * around)) * smoothstep(0.05, 0.0, abs(height - 0.55) - 0.05);
    vec3 walls = mix(vec3(0.015, 0.013, 0.012), vec3(0.05, 0.07, 0.11), smoothstep(-0.5, 0.9, height));
    return walls + lamp * vec3(3.2, 3.6, 4.6) + exp(-40.0 * (height + 0.35) * (height + 0.35)) * vec3(0.1, 0.05, 0.02);
}
