// right
// No counter: each invocation counts for a scale of its own, and the interval becomes 256 times narrower each time.
shared uint counts[LEVEL_INVOCATIONS];

float border_of(uint i, float lower, float upper) { return lower + (upper - lower) * float(i) / 255.0; }

float alpha_scale(uint local, float cutoff, float wanted) {
    float count = wanted * float(level_texels()), lower = 1e-5, upper = 2.0, result = 0.0, nearest = 1e9;
    for (int round = 0; round < 4; ++round) {
        uint kept = 0u;
        for (uint i = 0u; i < level_texels(); ++i)
            if (is_kept(level_alpha(i) * cutoff / border_of(local, lower, upper))) ++kept;
        barrier();
        counts[local] = kept;
        barrier();
        uint last = 0u;  // that keeps enough
        for (uint i = 0u; i < 256u; ++i) {
            if (float(counts[i]) >= count) last = i;
            if (abs(float(counts[i]) - count) < nearest) {
                nearest = abs(float(counts[i]) - count);
                result = cutoff / border_of(i, lower, upper);
            }
        }
        float from = border_of(last, lower, upper);
        upper = border_of(min(last + 1u, 255u), lower, upper);
        lower = from;
    }
    return result;
}
