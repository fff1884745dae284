// A second map, of its own, that shifts all textures along the view.
#include "04_surface_maps/parallax_offset.glsl"

// [displacement]
// How far the texture coordinates move where this map has `height`: one look, as if the surface lay at
// (height - 1/2) * displacement_m above the mesh. Limited, because nothing searches for the true hit afterwards: with the
// division by z a swell of slope s shows places twice from tan(angle) = 1/s on. `whole` is how far one unit of u and of v
// goes from black to white; `to_eye` as for parallax_offset.
vec2 displacement_shift(float height, vec3 to_eye, vec2 whole) {
    return parallax_offset_limited(0.5 - height, to_eye, whole);
}
// [/displacement]
