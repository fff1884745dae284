// Exercise 04.parallax_offset: one look at the height map, one guess where the eye's ray meets the surface.
// Until you fill it in, the surface is flat.

// [parallax_offset]
// How far the texture coordinates move. `depth` is the map's depth at the point, 0 to 1; `to_eye` is a unit vector in
// tangent space (x along u, y along v, z along the normal; z is above 0); `deepest` says how many units of u and of v
// depth 1 is. Take the surface for a plane at that depth, and go down along the ray until you meet it.
// [/parallax_offset]
vec2 parallax_offset(float depth, vec3 to_eye, vec2 deepest) {
    return vec2(0.0);
}

// [parallax_offset_limited]
// The same, limited: never further than depth * deepest, however flat the ray. Leave out what makes it grow.
// [/parallax_offset_limited]
vec2 parallax_offset_limited(float depth, vec3 to_eye, vec2 deepest) {
    return vec2(0.0);
}
