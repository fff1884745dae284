// Exercise 04.alpha_scale: an alpha scale that keeps the coverage of a cutout in its small mip levels.
// Starter: alpha is only averaged, and thin leaves vanish in the distance.

// [alpha_scale]
// One workgroup of LEVEL_INVOCATIONS invocations runs this function for one mip level.
// `local` numbers the invocations from 0; use it, not gl_LocalInvocationIndex. They share
// the variables declared `shared`; you may add more.
//
// Returns the factor, 0 or more, by which every alpha of the level is to be multiplied: the
// same for every invocation. A texel p, from 0 to level_texels() - 1, is kept if
// is_kept(level_alpha(p) * scale), so a larger factor keeps more texels. The number of
// texels kept must be as close to wanted * level_texels() as any factor can bring it; if
// less than half a texel is wanted, that is none. `wanted` is 0 to 1. `cutoff`, the
// threshold of is_kept, is above 0. Alphas that differ by less than 1/250 of their value
// may be treated as equal.
// [/alpha_scale]
shared uint kept;  // atomicAdd

float alpha_scale(uint local, float cutoff, float wanted) {
    return 1.0;
}
