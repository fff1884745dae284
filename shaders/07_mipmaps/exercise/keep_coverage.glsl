// Exercise 07.keep_coverage: alpha that is averaged lets leaves vanish. By what must a level's alpha be multiplied?
// Until you fill it in, by nothing.
#include "07_mipmaps/alpha_count.glsl"

// [keep_coverage]
// texels_with(code) says how many of the level's texels have the alpha code / 255, for code from 0 to 255. Returns the
// factor, above 0, with which the number of texels whose alpha * factor is at least `cutoff` (above 0, at most 1) comes
// as near to `wanted` as it can. Of factors that come equally near any will do. No texel may sit on the edge: leave room
// for rounding on both sides, half a code of alpha. A texel of alpha 0 cannot be made to reach anything.
// [/keep_coverage]
float keep_coverage(float wanted, float cutoff) {
    return 1.0;
}
