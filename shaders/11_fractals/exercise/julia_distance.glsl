// Exercise 11.julia_distance: how far one may go from a point without coming upon the set.
// Until you fill it in, one may go as far as to a ball.
#include "11_fractals/quaternion_square.glsl"

// [julia_distance]
// Replace z by z² + c, quaternion_square(z) + c, until |z| is above `escape` (2 to 64), at most `iterations` times (1 to
// 256). With it goes the length of the derivative of z by the point that it began with: 1 at first, then in each turn
// multiplied by 2 |z|, of the z before it is replaced. Where z has escaped, the distance is
//     0.25 sqrt(|z|² / |z'|²) log(|z|²),
// also where it had escaped before the first turn. A point that does not escape is taken for one of the set: 0, whatever
// |z'| is. Three traps: |z'|² grows beyond all floats after 32 turns at |z| = 2 - a point whose |z'|² exceeds 1e30 is so
// near that the result is 0, too. |z'| is 0 from a turn on that begins with z = 0: where such a point escapes it says
// nothing of its distance, and the result is 0.05. And no logarithm of what has not escaped.
// [/julia_distance]
float julia_distance(vec4 z, vec4 c, int iterations, float escape) {
    return max(length(z) - 1.0, 0.0);
}
