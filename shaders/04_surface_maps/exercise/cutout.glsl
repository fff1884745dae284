// Exercise 04.cutout: which points of a surface are not there.
// Until you fill it in, everything is there.

// [surface_alpha]
// What the colour texture's alpha, the opacity texture and the material's opacity say together: each takes its share.
// [/surface_alpha]
float surface_alpha(float color_alpha, float opacity_texel, float opacity) {
    return 1.0;
}

// [is_cut_out]
// True where the point is cut out: its alpha is below the cutoff. At the cutoff it stays.
// [/is_cut_out]
bool is_cut_out(float alpha, float cutoff) {
    return false;
}
