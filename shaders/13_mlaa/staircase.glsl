// How far the outline along a staircase of single steps stands above the line through the middles of its steps.
#include "13_mlaa/diagonal_bits.glsl"
#include "13_mlaa/edge_source.glsl"

uniform usampler2D diagonals;  // valid beside edges

// A staircase and one of its steps, which are the edges below pixels: how many to its ends, that one counted, and which way
// it runs (1 falling, -1 rising).
struct Staircase {
    ivec2 step;  // the pixel above the step's edge
    int back, ahead, way;
};

Staircase staircase_at(ivec2 pixel, bool falling) {
    uint word = edge_below(pixel) ? texelFetch(diagonals, pixel, 0).x : 0u;
    return Staircase(pixel, int(byte_of(word, falling ? back_falling : back_rising)),
                     int(byte_of(word, falling ? ahead_falling : ahead_rising)), falling ? 1 : -1);
}

ivec2 first_of(Staircase s) { return s.step - (s.back - 1) * ivec2(s.way, 1); }
ivec2 last_of(Staircase s) { return s.step + (s.ahead - 1) * ivec2(s.way, 1); }

// From four edges on, those below and those across: with three it is a turn of some line.
bool is_staircase(Staircase s) {
    int steps = s.back + s.ahead - 1;
    return s.back > 0 && (steps > 2 || steps == 2 && (edge_before(first_of(s), s.way) || edge_after(last_of(s), s.way)));
}

// [staircase_height]
// In the middle between two edges that are twice as long as a step the outline changes sides: half a pixel above the steps'
// middles at one end, half below at the other. `at`: where along the staircase, in steps from the step's start; the middle
// of its edge below is 1/2, that of the edge across 1.
float staircase_height(Staircase s, float at) {
    ivec2 first = first_of(s), last = last_of(s), along = ivec2(s.way, 1), aside = ivec2(s.way, 0);
    // (where the end lies before the first step's start or beyond the last's end, and by how much the outline is higher)
    vec2 end = vec2(0.0), start = vec2(0.0);
    if (edge_before(first, s.way)) {
        if (edge_before(first - ivec2(0, 1), s.way)) start = vec2(0.25, 0.5);
    } else if (edge_below(first - aside)) start = vec2(-0.25, -0.5);
    if (edge_after(last, s.way)) {
        if (edge_after(last + ivec2(0, 1), s.way)) end = vec2(0.25, -0.5);
    } else if (edge_below(last + aside)) end = vec2(-0.25, 0.5);
    float from_start = float(s.back - 1) + at + start.x, to_end = float(s.ahead) - at + end.x;
    float half_way = 0.5 * (from_start + to_end);
    return start.y * max(0.0, 1.0 - from_start / half_way) + end.y * max(0.0, 1.0 - to_end / half_way);
}
// [/staircase_height]

// Above the edge a corner is cut off the pixel where the edge across before it stands, below it where that after it does;
// both legs of that triangle are half a pixel, more by the height or less by it.
float corner_above(Staircase s) {
    float leg = edge_before(s.step, s.way) ? 0.5 + staircase_height(s, 0.25) : 0.0;
    return 0.5 * leg * leg;
}
float corner_below(Staircase s) {
    float leg = edge_after(s.step, s.way) ? 0.5 - staircase_height(s, 0.75) : 0.0;
    return 0.5 * leg * leg;
}
