// How many texels of a level have an alpha, by its code 0 to 255.
#ifdef FIELD
// For checks: levels whose texels are known.
uint texels_with(int code) {
#if FIELD == 0
    return 4u;                              // as many of each
#elif FIELD == 1
    return code == 60 ? 1000u : 0u;         // all alike
#elif FIELD == 2
    return code < 128 ? uint(128 - code) : 0u;
#elif FIELD == 3
    return code == 0 ? 90u : code == 255 ? 10u : 0u;
#elif FIELD == 4
    return code == 0 ? 64u : 0u;            // nothing is there
#else
    return uint(code * 37 % 11);
#endif
}
#else
layout(scalar) buffer AlphaBuffer { uint alpha_count[]; };  // 256 for each level of each layer
int counted = 0;  // which of these

uint texels_with(int code) { return alpha_count[256 * counted + code]; }
#endif
