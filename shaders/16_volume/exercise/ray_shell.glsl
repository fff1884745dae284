// Exercise 16.ray_shell: where a ray is inside a ball.
// Starter: no ray meets it, and the sphere is empty.

// [ray_shell]
// A ball of `radius` metres (above 0) is centred at the origin of the coordinate system.
// The ray starts at `origin` and runs along `direction`, which has unit length. Returns
// (entry, exit), in metres along the ray, of the part of the ray that lies inside the ball
// and in front of the start: a start inside the ball has an entry of 0.
//
// If the ray misses the ball, or the ball lies behind the start, exit <= entry; both must
// be ordinary numbers, so no square root of a negative number.
//
// For a ball of 1 m seen from 1,000 m, both must be right to 0.001 m. The discriminant
// b^2 - c, with b = dot(origin, direction) and c = dot(origin, origin) - radius^2, is too
// coarse there: it subtracts two numbers near a million, which floats hold in steps of
// 1/16. Use the distance of the ray from the centre instead. It is the length of
// origin - dot(origin, direction) * direction, and small.
// [/ray_shell]
vec2 ray_shell(vec3 origin, vec3 direction, float radius) {
    return vec2(0.0);
}
