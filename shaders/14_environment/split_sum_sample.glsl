// One sample of the two integrals that the split sum keeps in a table.
#include "14_environment/environment_brdf.glsl"

#ifndef SPLIT_SUM_GIVEN  // checks have samples of their own
const uint split_sum_threads = 256u;

vec2 split_sum_sample(uint i, uint samples, float n_dot_v, float alpha) {
    return environment_brdf(hammersley(i, samples), n_dot_v, alpha);
}
#endif
