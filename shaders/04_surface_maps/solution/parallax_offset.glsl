// Solution of 04.parallax_offset.

// T. Kaneko et al., "Detailed Shape Representation with Parallax Mapping", ICAT 2001.
vec2 parallax_offset(float depth, vec3 to_eye, vec2 deepest) {
    return -depth * deepest * to_eye.xy / to_eye.z;
}

// T. Welsh, "Parallax Mapping with Offset Limiting", 2004: without the division.
vec2 parallax_offset_limited(float depth, vec3 to_eye, vec2 deepest) {
    return -depth * deepest * to_eye.xy;
}
