// Exercise 04.cutout: the alpha of a surface point, and the test that cuts holes.
// Starter: nothing is cut out.

// [surface_alpha]
// The alpha of a surface point: the product of the colour texture's alpha, the opacity
// texture and the material's opacity.
// [/surface_alpha]
float surface_alpha(float color_alpha, float opacity_texel, float opacity) {
    return 1.0;
}

// [is_cut_out]
// True if the point is cut out, that is, if its alpha is below the cutoff. A point exactly
// at the cutoff stays.
// [/is_cut_out]
bool is_cut_out(float alpha, float cutoff) {
    return false;
}
