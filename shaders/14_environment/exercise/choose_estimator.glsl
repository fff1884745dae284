// Exercise 14.choose_estimator: choose and defend: directions for three integrals of light.
// Starter: many directions, spread evenly.

// [choose_estimator]
// Light that a surface reflects is estimated from n directions (Hammersley points). `surface` is
// one of three; y is its normal, and the camera looks along it:
// - 0: matt, under clouds, whose light depends on the direction smoothly;
// - 1: polished, with a lobe of alpha 0.04, under the same clouds;
// - 2: matt, under an even sky with a sun in it, a disc of 0.06 rad that is 1,000 times as bright.
//
// Returns the method and n, 2 to 256. Methods:
// - 1: directions evenly over the hemisphere;
// - 2: as the cosine with the normal;
// - 3: as the lobe of GGX (alpha 1 on matt surfaces);
// - 4: half of them evenly over the sun's disc, and for the sky without the sun the others as the
//   cosine. Without a sun it is method 2 with n / 2.
//
// Limits: surface 0 may cost 16 directions and err by 0.4%, surface 1 8 directions and 2.5%, surface
// 2 16 directions and 1%. The check measures both and prints them.
// [/choose_estimator]
ivec2 choose_estimator(int surface) {
    return ivec2(1, 256);
}
