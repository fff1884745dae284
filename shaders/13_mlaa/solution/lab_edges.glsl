// Solution of 13.lab_edges.
#include "13_mlaa/lab_source.glsl"

uint lab_edges(ivec2 corner, float threshold) {
    int own = int(gl_LocalInvocationIndex);
    for (int slot = own; slot < kept_side * kept_side; slot += tile_side * tile_side)
        keep_lab(slot, lab_at(corner - 1 + ivec2(slot % kept_side, slot / kept_side)));
    barrier();  // every colour is loaded, by any invocation
    int slot = (own / tile_side + 1) * kept_side + own % tile_side + 1;
    vec3 lab = kept_lab(slot);
    uint edges = 0u;
    if (lab_distance(lab, kept_lab(slot + 1)) > threshold) edges |= 1u;
    if (lab_distance(lab, kept_lab(slot + kept_side)) > threshold) edges |= 2u;
    if (lab_distance(lab, kept_lab(slot - 1)) > threshold) edges |= 4u;
    if (lab_distance(lab, kept_lab(slot - kept_side)) > threshold) edges |= 8u;
    return edges;
}
