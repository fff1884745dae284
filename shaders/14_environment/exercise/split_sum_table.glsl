// Exercise 14.split_sum_table: the mean of many samples, taken by a whole workgroup.
// Starter: each thread returns a sample of its own, and the table holds that of the first.
#include "14_environment/split_sum_sample.glsl"

// [split_sum_table]
// The mean of split_sum_sample(i, samples, n_dot_v, alpha) over every i below
// `samples`, from 0 on. One workgroup of split_sum_threads invocations (256, a power of
// two) computes one texel of the table: all of them call this together, with the same
// arguments but for `thread`, 0 to split_sum_threads - 1. Thread 0 must return the
// mean; what others return is not used. Each sample is computed once, by one thread.
// `samples` is 1 or more, and need not be a multiple of split_sum_threads. What one
// thread writes to shared memory is visible to the others only after a barrier(), which
// all threads must reach: never place it within a branch that some of them skip.
// [/split_sum_table]
vec2 split_sum_table(float n_dot_v, float alpha, uint samples, uint thread) {
    return split_sum_sample(min(thread, samples - 1u), samples, n_dot_v, alpha);
}
