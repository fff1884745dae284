// For 13.lab_edges: a workgroup's square of pixels, and the shared memory to keep their colours in.
#include "13_mlaa/lab_distance.glsl"

const int tile_side = 16;               // pixels; a thread for each
const int kept_side = tile_side + 2;    // with those around it
// A float each, L, a and b apart: neighbours then lie in different banks. 4 KiB.
shared float kept[3][kept_side * kept_side];

void keep_lab(int slot, vec3 lab) {
    kept[0][slot] = lab.x;
    kept[1][slot] = lab.y;
    kept[2][slot] = lab.z;
}
vec3 kept_lab(int slot) { return vec3(kept[0][slot], kept[1][slot], kept[2][slot]); }

// Slow: a read of the picture and three powers. Outside of the picture it is the nearest pixel inside.
vec3 lab_at(ivec2 pixel);
