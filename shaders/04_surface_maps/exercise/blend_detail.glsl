// Exercise 04.blend_detail: fine bumps on top of coarse ones.
// Starter: there are no fine bumps.

// [blend_detail]
// Both arguments are unit vectors in tangent space with z at least 0. The result is
// `detail`, rotated by the rotation that takes (0, 0, 1) to `base`, and of unit length. So
// a flat base gives `detail`, and a flat detail gives `base`. With t = base + (0, 0, 1) and
// u = detail * (-1, -1, 1), the rotated vector is t * dot(t, u) / t.z - u.
// [/blend_detail]
vec3 blend_detail(vec3 base, vec3 detail) {
    return base;
}
