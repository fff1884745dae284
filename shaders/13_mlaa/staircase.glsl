// How far the outline along a staircase of single steps stands above the line through the middles of its steps.
#include "13_mlaa/diagonal_bits.glsl"
#include "13_mlaa/edge_source.glsl"

uniform usampler2D diagonals;

uint diagonals_at(ivec2 pixel) {
    bool inside = all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, textureSize(diagonals, 0)));
    return inside ? texelFetch(diagonals, pixel, 0).x : 0u;
}

// A staircase and one of its steps: steps to its ends, that one counted; which way it runs (1 falling, -1 rising).
struct Staircase {
    ivec2 step;  // the pixel above the step's edge
    int back, ahead, way;
};

Staircase staircase_at(ivec2 pixel, bool falling) {
    uint word = diagonals_at(pixel);
    return Staircase(pixel, int(byte_of(word, falling ? back_falling : back_rising)),
                     int(byte_of(word, falling ? ahead_falling : ahead_rising)), falling ? 1 : -1);
}

// The edge across that stands at the side of a pixel to which the staircase runs.
bool edge_ahead(ivec2 pixel, int way) { return edge_right(way > 0 ? pixel : pixel - ivec2(1, 0)); }

// [staircase_height]
// In the middle between two edges that are twice as long as a step the outline changes sides: half a pixel above the steps'
// middles at one end, half below at the other. `at`: where along the staircase, in steps from the step's start; the middle
// of its edge below is 1/2, that of the edge across 1.
float staircase_height(Staircase s, float at) {
    ivec2 along = ivec2(s.way, 1), aside = ivec2(s.way, 0);
    ivec2 first = s.step - (s.back - 1) * along, last = s.step + (s.ahead - 1) * along;
    // (where the end lies beyond the last whole step, and by how much the outline is higher there)
    vec2 end = vec2(0.0), start = vec2(0.0);
    bool lies = edge_below(last + along), lay = edge_ahead(first - aside, s.way);
    if (lies && edge_below(last + along + aside)) end = vec2(0.75, 0.5);
    if (!lies && edge_ahead(last + ivec2(0, 2), s.way)) end = vec2(0.25, -0.5);
    if (!lay && edge_below(first - aside)) start = vec2(0.25, -0.5);
    if (lay && !edge_below(first - along) && edge_ahead(first - along, s.way)) start = vec2(-0.25, 0.5);
    float from_start = float(s.back - 1) + at - start.x, to_end = float(s.ahead) - at + end.x;
    float half_way = 0.5 * (from_start + to_end);
    return start.y * max(0.0, 1.0 - from_start / half_way) + end.y * max(0.0, 1.0 - to_end / half_way);
}
// [/staircase_height]

// Above the edge a corner is cut off the pixel, below it another; both legs of that triangle are half a pixel, more by the
// height or less by it.
float corner_above(Staircase s) {
    float leg = 0.5 + staircase_height(s, 0.25);
    return 0.5 * leg * leg;
}
float corner_below(Staircase s) {
    float leg = 0.5 - staircase_height(s, 0.75);
    return 0.5 * leg * leg;
}
