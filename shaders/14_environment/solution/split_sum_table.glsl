// Solution of 14.split_sum_table.
#include "14_environment/split_sum_sample.glsl"

shared vec2 partial_sums[split_sum_threads];

vec2 split_sum_table(float n_dot_v, float alpha, uint samples, uint thread) {
    vec2 sum = vec2(0.0);
    for (uint i = thread; i < samples; i += split_sum_threads) sum += split_sum_sample(i, samples, n_dot_v, alpha);
    partial_sums[thread] = sum;
    for (uint half_of = split_sum_threads / 2u; half_of > 0u; half_of /= 2u) {
        barrier();
        if (thread < half_of) partial_sums[thread] += partial_sums[thread + half_of];
    }
    return partial_sums[0] / float(samples);
}
