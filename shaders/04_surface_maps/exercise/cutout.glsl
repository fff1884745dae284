// Exercise 04.cutout: which points of a surface are not there.
// Until you fill it in, everything is there.

// What the colour texture's alpha, the opacity texture and the material's opacity say together: each takes its share.
float surface_alpha(float color_alpha, float opacity_texel, float opacity) {
    return 1.0;
}

// True where the point is cut out: its alpha is below the cutoff. At the cutoff it stays.
bool is_cut_out(float alpha, float cutoff) {
    return false;
}
