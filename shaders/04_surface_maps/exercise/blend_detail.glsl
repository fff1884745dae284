// Exercise 04.blend_detail: fine bumps on coarse ones.
// Until you fill it in, there are no fine ones.

// [blend_detail]
// Both are unit vectors in tangent space with z at least 0. The result is `detail`, turned by the rotation that takes
// (0, 0, 1) to `base`: on a flat base it is the detail, with a flat detail it is the base. Unit length.
// With t = base + (0, 0, 1) and u = detail * (-1, -1, 1) the rotation is t * dot(t, u) / t.z - u.
// [/blend_detail]
vec3 blend_detail(vec3 base, vec3 detail) {
    return base;
}
