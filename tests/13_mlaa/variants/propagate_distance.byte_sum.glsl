// wrong: propagate_distance(
// applications", 2005, on distances.
#include "13_mlaa/known_distance.glsl"

uint propagate_distance(int reads, uint reach) {
    uint sum = known(0u);
    for (int i = 1; i < reads && sum < reach; ++i) {
        uint more = known(sum);
        if (more == 0u) break;
        sum = sum + more & 255u;
    }
    return min(sum, reach);
}
