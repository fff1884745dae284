// Exercise 05.light_clip_position: where in a light's map a point is.
// Until you fill it in, every point lies in the middle of the map, as near to the light as can be: all is lit.

// [light_clip_position]
// xy: texture coordinates, (0, 0) at the map's first texel and (1, 1) beyond its last; z: the depth that a map drawn with
// `to_clip` holds where it sees the point. In clip space y points down, as v does; x and y go from -w to w, z from 0 to w.
// Points outside the view get coordinates outside 0 to 1. A point with w <= 0 is behind the light, which does not see it:
// the result is vec3(-1).
// [/light_clip_position]
vec3 light_clip_position(mat4 to_clip, vec3 position) {
    return vec3(0.5, 0.5, 1.0);
}
