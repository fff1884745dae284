// wrong: keep_coverage(
#include "07_mipmaps/alpha_count.glsl"

float keep_coverage(float wanted, float cutoff) {
    // Keeps the sum of alpha instead of how many are above the cutoff.
    float sum = 0.0;
    for (int code = 0; code < 256; ++code) sum += float(code) / 255.0 * float(texels_with(code));
    return max(wanted, 1.0) / max(sum, 1.0);
}
