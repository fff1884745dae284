// Work of later passes: the pixels beside an edge, and their number of workgroups. It stays on the device.
#ifndef WORK_ACCESS
#define WORK_ACCESS coherent
#endif
struct Work {
    uint groups[3];  // of an indirect dispatch
    uint listed_count;
    uint changed_count;  // pixels that were mixed with a neighbour
};
layout(scalar) WORK_ACCESS buffer WorkBuffer { Work work; };

const uint listed_threads = 256u;    // of a workgroup that goes through the list
const uint most_groups = 65535u;     // guaranteed on every device

ivec2 unpack_pixel(uint word) { return ivec2(word & 0xffffu, word >> 16); }
uint pack_pixel(ivec2 pixel) { return uint(pixel.x) | uint(pixel.y) << 16; }
