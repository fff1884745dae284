// Exercise 16.bake_ray: the rays that measure how much light a groove loses.
// Starter: no ray counts; whatever no lamp lights is black.

// [bake_ray]
// One of the rays that leave a texel. `even` is a point of a set that covers the square
// 0 <= x, y < 1 evenly, the same number of points on equal areas. Returns the ray's direction in
// xyz, of length 1, with z along the normal of the surface and at least 0; and in w what the ray
// counts for if it meets nothing. The mean of w, with 0 for the rays that meet something, must
// tend to the integral of cos θ / π over the open directions, where θ is the angle to the normal.
// Where all directions are open it must be exactly 1, with a single ray as well as with many.
// [/bake_ray]
vec4 bake_ray(vec2 even) {
    return vec4(0.0, 0.0, 1.0, 0.0);
}
