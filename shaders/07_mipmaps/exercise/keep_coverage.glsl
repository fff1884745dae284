// Exercise 07.keep_coverage: averaged alpha makes leaves vanish; find the factor that brings them back.
// Starter: the factor is 1.
#include "07_mipmaps/alpha_count.glsl"

// [keep_coverage]
// A texel is kept if its alpha * factor is at least `cutoff` (above 0, at most 1).
// Returns a factor above 0 for which the number of kept texels is as near to `wanted`
// as any factor can bring it. Of several equally good factors, any is right.
//
// texels_with(code) is the number of texels in this level whose alpha is code / 255,
// for code from 0 to 255. The texels of one code are kept or discarded together, and a
// code is never kept if a higher one is not. A texel of alpha 0 cannot be kept by any
// factor.
//
// Rounding must not change the result: no texel may lie exactly at the cutoff. Choose
// the factor so that every code could be half a code higher or lower and still be on
// the same side of the test.
// [/keep_coverage]
float keep_coverage(float wanted, float cutoff) {
    return 1.0;
}
