// Exercise 12.stretch_scale: a Gaussian is millimetres wide, a blur counts texels.
// Until you fill it in, every texel is taken for a millimetre wide.

// [stretch_scale]
// du_mm and dv_mm say how far the surface goes, in mm, from one texel of the map to the next along u and along v. Returns
// how many texels a millimetre is along u (x) and along v (y): by what sigma in mm is multiplied, in a blur that goes
// along one of the two. Where a texture is pinched to a point a step goes nowhere: no component is above most_texels, and
// a step of no length gives just that.
// [/stretch_scale]
vec2 stretch_scale(vec3 du_mm, vec3 dv_mm, float most_texels) { return vec2(1.0); }
