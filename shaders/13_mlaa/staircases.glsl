// Staircases of single steps.
#include "13_mlaa/distance_bits.glsl"
#include "13_mlaa/edge_source.glsl"
#include "13_mlaa/lines.glsl"

// A staircase and one of its steps, which are the edges below pixels: how many to its ends, that one counted, and which way
// it runs (1 falling, -1 rising).
struct Staircase {
    ivec2 step;  // the pixel above the step's edge
    int back, ahead, way;
};

// Whether the edge below a pixel is a step of one, without its length. From four edges on, those below and those across:
// with three it is a turn of some line.
bool is_staircase(ivec2 pixel, int way) {
    ivec2 along = ivec2(way, 1);
    bool below = edge_below(pixel), before = edge_before(pixel, way), after = edge_after(pixel, way);
    bool back = edge_below(pixel - along), ahead = edge_below(pixel + along);
    bool first = edge_before(pixel - along, way), last = edge_after(pixel + along, way);
    return below && (before && back && (first || after) || after && ahead && (before || last));
}

#if MLAA_READS == MLAA_READS_WORDS
// Steps from a pixel's on, itself counted, where `ahead` is 1 downwards and -1 upwards. Four are asked at once: none of
// these reads waits for another.
const int asked = 4;
int walked(ivec2 pixel, int way, int ahead) {
    for (int steps = 1; steps < mlaa.reach; steps += asked) {
        uint ends = 1u << asked;
        for (int k = 0; k < asked; ++k) {
            ivec2 at = pixel + (steps + k - 1) * ahead * ivec2(way, 1);
            ends |= uint(!(ahead > 0 ? follows_after(at, way) : follows_before(at, way))) << k;
        }
        int more = findLSB(ends);
        if (more < asked) return min(steps + more, mlaa.reach);
    }
    return mlaa.reach;
}

Staircase staircase_at(ivec2 pixel, int way) { return Staircase(pixel, walked(pixel, way, -1), walked(pixel, way, 1), way); }
#else
uniform usampler2D diagonals;  // valid beside edges

Staircase staircase_at(ivec2 pixel, int way) {
    uint word = texelFetch(diagonals, pixel, 0).x;
    return Staircase(pixel, int(byte_of(word, way > 0 ? back_falling : back_rising)),
                     int(byte_of(word, way > 0 ? ahead_falling : ahead_rising)), way);
}
#endif

ivec2 first_of(Staircase s) { return s.step - (s.back - 1) * ivec2(s.way, 1); }
ivec2 last_of(Staircase s) { return s.step + (s.ahead - 1) * ivec2(s.way, 1); }
