// right
#include "13_mlaa/lab_source.glsl"
uint lab_edges(ivec2 corner, float threshold) {
    int own = int(gl_LocalInvocationIndex);
    ivec2 at = ivec2(own & 15, own >> 4);
    ivec2 from = at + 1;
    keep_lab(from.y * 18 + from.x, lab_at(corner + at));
    if (own < 64) {
        int side = own >> 4, i = own & 15;
        ivec2 rim = side == 0 ? ivec2(i, -1) : side == 1 ? ivec2(i, 16) : side == 2 ? ivec2(-1, i) : ivec2(16, i);
        keep_lab((rim.y + 1) * 18 + rim.x + 1, lab_at(corner + rim));
    }
    memoryBarrierShared();
    barrier();
    vec3 lab = kept_lab(from.y * 18 + from.x);
    const ivec2 sides[] = ivec2[](ivec2(1, 0), ivec2(0, 1), ivec2(-1, 0), ivec2(0, -1));
    uint edges = 0u;
    for (int i = 0; i < 4; ++i) {
        ivec2 to = from + sides[i];
        edges += lab_distance(lab, kept_lab(to.y * 18 + to.x)) > threshold ? 1u << i : 0u;
    }
    return edges;
}
