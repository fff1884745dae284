// Tint of a listed fragment in 32 bits.

// Roots, so that dark tints keep their steps: at a share s they are sqrt(s) / 512 apart.
uint packed_tint(vec3 tint) {
    uvec3 root = uvec3(round(1023.0 * sqrt(clamp(tint, 0.0, 1.0))));
    return root.r | root.g << 10 | root.b << 20;
}

vec3 unpacked_tint(uint tint) {
    vec3 root = vec3(uvec3(tint, tint >> 10, tint >> 20) & 1023u) / 1023.0;
    return root * root;
}
