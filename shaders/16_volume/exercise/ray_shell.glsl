// Exercise 16.ray_shell: where a ray is inside a ball.
// As it stands no ray meets it, and the sphere is empty.

// [ray_shell]
// A ball of `radius` metres (above 0) stands around the origin. The ray goes from `origin` along `direction`, which has
// unit length. Returns (enters, leaves) in metres along the ray, of the part of the ray inside the ball: an eye in the ball
// enters at 0, and a ball behind the eye is not met. Where the ray misses the ball, leaves <= enters, and both are numbers:
// no square root of less than 0. A ball of 1 m seen from 1,000 m must be right to 0.001 m: b² - c with b = dot(origin,
// direction) and c = dot(origin, origin) - radius² subtracts two numbers of a million there, of which floats keep 1/16. The
// ray's distance from the centre is the length of origin - dot(origin, direction) * direction, which is small.
// [/ray_shell]
vec2 ray_shell(vec3 origin, vec3 direction, float radius) {
    return vec2(0.0);
}
