// Solution of 06.box_is_out.

bool box_is_out(vec3 center, vec3 half_size, vec4 plane) {
    // The corner farthest along the normal: if it is out, all eight are.
    return dot(plane.xyz, center) + dot(abs(plane.xyz), half_size) + plane.w < 0.0;
}
