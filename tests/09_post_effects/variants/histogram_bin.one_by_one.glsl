// wrong: was added to
#include "09_post_effects/histogram_source.glsl"
uint histogram_bin(float luminance) {
    if (!(luminance >= 1.0 / 4096.0)) return 0u;
    return 1u + uint(min((log2(min(luminance, 4096.0)) + 12.0) * 255.0 / 24.0, 254.0));
}
void count_together(uint bin, bool counts) {
    if (counts) add_to_picture(bin, 1u);
}
