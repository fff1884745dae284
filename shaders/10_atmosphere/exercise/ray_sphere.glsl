// Exercise 10.ray_sphere: where a ray enters a sphere, and where it leaves it.
// Until you fill it in, no ray meets anything.

// [ray_sphere]
// A ray starts `height` metres above a planet of `radius` metres (-0.1 radius to 10 radius); `slope` is the cosine of the
// angle between it and straight up. Returns the distances at which it meets the sphere that lies `shell` metres above the
// ground: the smaller one first, below 0 where it lies behind the start; both are the same where the ray touches it.
// vec2(1, -1) where it misses. radius + height is known to half a metre only, and its square to 2,000,000 square metres:
// compute no difference of squares, as height and shell say without loss what it is. And of the two roots -b + sqrt(d) and
// -b - sqrt(d) one is a small difference of large numbers: their product is known. From height 0 the ground is 0 away,
// exactly.
// [/ray_sphere]
vec2 ray_sphere(float height, float slope, float radius, float shell) {
    return vec2(1.0, -1.0);
}
