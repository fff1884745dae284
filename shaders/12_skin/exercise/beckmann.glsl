// Exercise 12.beckmann: how many of a rough surface's facets face along the half vector.
// Until you fill it in, all directions have the same number of facets.

// [beckmann]
// P. Beckmann and A. Spizzichino, 1963: D = exp(-tan²a / m²) / (pi m² cos⁴a), where cos a = n_dot_h (-1 to 1) and m is the
// root mean square slope of the facets, 0.005 to 1. Nothing faces below the horizon: 0 for n_dot_h <= 0. Near 0 tan²a grows
// beyond every float and cos⁴a is 0: what GLSL makes of a division by 0 is open, an infinity or not. The result is 0 there,
// found without such a division, and never a NaN. The integral of D n_dot_h over the hemisphere
// is 1: one paper leaves out the 1 / pi, and its skin shines three times too bright.
// [/beckmann]
float beckmann(float n_dot_h, float m) { return n_dot_h > 0.0 ? 0.31831 : 0.0; }
