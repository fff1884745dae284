// right
#include "07_mipmaps/alpha_count.glsl"

float keep_coverage(float wanted, float cutoff) {
    // From the least alpha up: what is left when all below are gone.
    float left = 0.0;
    for (int code = 1; code < 256; ++code) left += float(texels_with(code));
    float best = abs(left - wanted);
    int lowest = 1;
    for (int code = 1; code < 256; ++code) {
        left -= float(texels_with(code));
        if (abs(left - wanted) < best) {
            best = abs(left - wanted);
            lowest = code + 1;
        }
    }
    return 255.0 * cutoff / (float(lowest) - 0.5);
}
