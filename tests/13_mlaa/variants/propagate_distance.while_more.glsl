// right
#include "13_mlaa/known_distance.glsl"
uint propagate_distance(int reads, uint reach) {
    uint at = 0u, more = known(0u);
    while (--reads > 0 && more > 0u) {
        at += more;
        more = known(at);
    }
    return min(at + more, reach);
}
