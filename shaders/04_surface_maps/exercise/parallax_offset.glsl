// Exercise 04.parallax_offset: a hit point estimated from a single read of the height map.
// Starter: the surface is flat.

// [parallax_offset]
// The vector to add to the texture coordinates. `depth` is the depth in the map, 0 to 1,
// where the camera ray enters. `to_eye` is the unit vector to the camera in tangent space:
// x along u, y along v, z along the normal; z is above 0. `deepest` converts lengths: a
// length equal to depth 1 is deepest.x units of u and deepest.y units of v. Treat the
// surface as a plane at this depth, and follow the ray down until it meets the plane.
// [/parallax_offset]
vec2 parallax_offset(float depth, vec3 to_eye, vec2 deepest) {
    return vec2(0.0);
}

// [parallax_offset_limited]
// The same vector, with its length limited: never longer than depth * deepest, however flat
// the ray. Leave out the factor that makes it grow.
// [/parallax_offset_limited]
vec2 parallax_offset_limited(float depth, vec3 to_eye, vec2 deepest) {
    return vec2(0.0);
}
