// For the check of 07.keep_coverage: levels with known texels.
#pragma replaces "07_mipmaps/alpha_count.glsl"

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
