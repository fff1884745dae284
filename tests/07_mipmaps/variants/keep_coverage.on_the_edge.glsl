// wrong: on the edge
#include "07_mipmaps/alpha_count.glsl"

float keep_coverage(float wanted, float cutoff) {
    int lowest = 256;
    float off = wanted, reached = 0.0;
    for (int code = 255; code >= 1; --code) {
        reached += float(texels_with(code));
        if (abs(reached - wanted) < off) off = abs(reached - wanted), lowest = code;
    }
    return cutoff * 255.0 / (float(lowest) - 0.01);
}
