// Exercise 13.accumulate: a pixel's history, and one more sample.
// Starter: each frame forgets all others.

// [accumulate]
// The history of a pixel is the mean of the samples that were gathered so far: `history`, which
// is worth `samples` of them, 0 or more. Returns the mean together with one more, `fresh`, in xyz,
// and in w how many samples that is worth. Light is in YCoCg; x, the luma Y, is 0 or more.
//
// - The result is worth at most `most`: old light then fades. `most` may have fallen since the
//   frame before. The new sample always counts in full, so that a `most` below 1 is 1.
// - With `tone`, every sample counts by 1 / (1 + Y), which calms bright ones. The history's
//   samples all count by the Y of the history. What the result is worth stays the same.
// - A history that is worth 0 samples may hold anything, even infinity or NaN. No light of it may
//   be left.
// [/accumulate]
vec4 accumulate(vec3 fresh, vec3 history, float samples, float most, bool tone) {
    return vec4(fresh, 1.0);
}
