// Exercise 12.stretch_scale: texels per millimetre, because a Gaussian has a width in mm and a blur counts
// texels.
// Starter: every texel is assumed to be a millimetre wide.

// [stretch_scale]
// du_mm and dv_mm are the steps on the surface, in mm, from one texel of the map to the
// next one along u and along v. Returns the number of texels per millimetre along u (x)
// and along v (y): the factors that convert a sigma in mm to texels for a blur along
// that axis.
//
// Where the texture is pinched to a point, a step has no length. No component of the
// result is above most_texels, and a step of length 0 gives most_texels, each to a part
// in 100,000. 1 / 0 is undefined in GLSL: do not divide before you limit.
// [/stretch_scale]
vec2 stretch_scale(vec3 du_mm, vec3 dv_mm, float most_texels) { return vec2(1.0); }
