// wrong: is_cut_out(alpha = 0.5, cutoff = 0.5)
float surface_alpha(float color_alpha, float opacity_texel, float opacity) {
    return color_alpha * opacity_texel * opacity;
}

bool is_cut_out(float alpha, float cutoff) {
    return alpha <= cutoff;
}
