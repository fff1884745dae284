// Staircases of single steps.
#include "13_mlaa/distance_bits.glsl"
#include "13_mlaa/edge_source.glsl"

// A staircase and one of its steps, which are the edges below pixels: how many to its ends, that one counted, and which way
// it runs (1 falling, -1 rising).
struct Staircase {
    ivec2 step;  // the pixel above the step's edge
    int back, ahead, way;
};

uniform usampler2D diagonals;  // valid beside edges

Staircase staircase_at(ivec2 pixel, int way) {
    uint word = edge_below(pixel) ? texelFetch(diagonals, pixel, 0).x : 0u;
    return Staircase(pixel, int(byte_of(word, way > 0 ? back_falling : back_rising)),
                     int(byte_of(word, way > 0 ? ahead_falling : ahead_rising)), way);
}

ivec2 first_of(Staircase s) { return s.step - (s.back - 1) * ivec2(s.way, 1); }
ivec2 last_of(Staircase s) { return s.step + (s.ahead - 1) * ivec2(s.way, 1); }

// From four edges on, those below and those across: with three it is a turn of some line.
bool is_staircase(Staircase s) {
    int steps = s.back + s.ahead - 1;
    return s.back > 0 && (steps > 2 || steps == 2 && (edge_before(first_of(s), s.way) || edge_after(last_of(s), s.way)));
}
