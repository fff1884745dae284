// Exercise 11.julia_distance: a lower bound of the distance to a Julia set.
// Starter: it is the distance to a ball.
#include "11_fractals/quaternion_square.glsl"

// [julia_distance]
// Replace z by quaternion_square(z) + c until |z| is above `escape` (2 to 64), at most
// `iterations` times (1 to 256). Along with it, update |z'|, the length of the
// derivative of z by the starting point. It is 1 at first. Each iteration multiplies it
// by 2 |z|, with the z before it is replaced.
//
// If z has escaped, also before the first iteration, return
//
//     0.25 sqrt(|z|^2 / |z'|^2) log(|z|^2)
//
// Special cases:
// - A point that does not escape belongs to the set: 0, whatever |z'| is. The logarithm
//   must not be used for it.
// - |z'|^2 overflows a float after 32 iterations at |z| = 2. A point whose |z'|^2
//   exceeds 1e30 is so close that the result is 0.
// - If an iteration begins with z = 0, |z'| is 0 from then on. If such a point escapes,
//   the formula divides by 0: return 0.05.
// [/julia_distance]
float julia_distance(vec4 z, vec4 c, int iterations, float escape) {
    return max(length(z) - 1.0, 0.0);
}
