// How many texels of a level have an alpha, by its code 0 to 255.
layout(scalar) buffer AlphaBuffer { uint alpha_count[]; };  // 256 for each level of each layer
int counted = 0;  // which of these

uint texels_with(int code) { return alpha_count[256 * counted + code]; }
