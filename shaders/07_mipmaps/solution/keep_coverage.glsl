// Solution of 07.keep_coverage (I. Castaño, "Computing Alpha Mipmaps", 2010).
#include "07_mipmaps/alpha_count.glsl"

float keep_coverage(float wanted, float cutoff) {
    int lowest = 256;  // the least alpha that stays; 256: none does
    float off = wanted, reached = 0.0;
    for (int code = 255; code >= 1; --code) {
        reached += float(texels_with(code));
        if (abs(reached - wanted) < off) {
            off = abs(reached - wanted);
            lowest = code;
        }
    }
    return cutoff * 255.0 / (float(lowest) - 0.5);
}
