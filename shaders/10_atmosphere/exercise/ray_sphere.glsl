// Exercise 10.ray_sphere: the intersection of a ray with a sphere as large as a planet.
// Starter: no ray meets anything.

// [ray_sphere]
// A ray starts `height` metres above a planet of `radius` metres (height is -0.1 radius
// to 10 radius). `slope` is the cosine of the angle between the ray and straight up.
// Returns the distances along the ray to the sphere that lies `shell` metres above the
// ground, the smaller one first. A distance below 0 lies behind the start. If the ray
// touches the sphere, both are equal. If it misses, the result is vec2(1, -1).
//
// The distances t solve t^2 + 2 b t + c = 0 with b = (radius + height) * slope and
// c = (radius + height)^2 - (radius + shell)^2. In floats, two differences lose all
// digits:
// - At the radius of a planet, (radius + height)^2 is known only to 2,000,000 square
//   metres. Write c as a product in which height and shell appear by themselves.
// - Of the two roots -b + sqrt(b^2 - c) and -b - sqrt(b^2 - c), one is a small
//   difference of large numbers. Compute the other one, and find this one from the
//   product of both, which is c.
//
// If the ray starts on the sphere, one distance is exactly 0; avoid 0/0 there.
// [/ray_sphere]
vec2 ray_sphere(float height, float slope, float radius, float shell) {
    return vec2(1.0, -1.0);
}
