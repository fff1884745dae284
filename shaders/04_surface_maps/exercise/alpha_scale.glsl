// Exercise 04.alpha_scale: how leaves stay leaves in the small levels of a cutout.
// As it stands alpha is only averaged, and thin leaves vanish from afar.

// [alpha_scale]
// LEVEL_INVOCATIONS invocations, one workgroup, run this at once for one level; `local` counts them from 0: use it, not
// gl_LocalInvocationIndex. They share what is `shared`; you may add to it.
//
// By what every alpha of the level is to be multiplied, 0 or more, the same for every invocation. Then the texels p, from
// 0 to level_texels() - 1, are kept for which is_kept(level_alpha(p) * scale): the larger the scale, the more. Their number
// is to be as near to wanted * level_texels() as a scale brings it: none, where one is too many. `wanted` is from 0 to 1,
// `cutoff`, which is_kept asks for, above 0. Alphas that differ by less than a 250th of themselves may be taken as equal.
// [/alpha_scale]
shared uint kept;  // atomicAdd

float alpha_scale(uint local, float cutoff, float wanted) {
    return 1.0;
}
