// Solution of 04.alpha_scale (after I. Castaño, "Computing Alpha Mipmaps", 2010): bisection for the alpha that is
// scaled to the cutoff.
shared uint kept;

float kept_with(uint local, float scale) {
    barrier();  // no reset while another invocation still reads
    if (local == 0u) kept = 0u;
    barrier();
    for (uint i = local; i < level_texels(); i += LEVEL_INVOCATIONS)
        if (is_kept(level_alpha(i) * scale)) atomicAdd(kept, 1u);
    barrier();
    return float(kept);
}

float alpha_scale(uint local, float cutoff, float wanted) {
    float count = wanted * float(level_texels());
    float lower = 1e-5, upper = 2.0;  // cutoff / lower keeps too many or just as many, cutoff / upper none
    for (int i = 0; i < 22; ++i) {
        float middle = upper > 2.0 * lower ? sqrt(lower * upper) : 0.5 * (lower + upper);
        if (kept_with(local, cutoff / middle) < count)
            upper = middle;
        else
            lower = middle;
    }
    float too_many = kept_with(local, cutoff / lower) - count, too_few = count - kept_with(local, cutoff / upper);
    return cutoff / (too_few < too_many ? upper : lower);
}
