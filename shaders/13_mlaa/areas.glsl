// The table of exercise 13.area.
uniform sampler2D areas;  // by the pixels to the end that turns, and to the other, each less one

float area_at(int to_end, int to_other) { return texelFetch(areas, min(ivec2(to_end, to_other), textureSize(areas, 0)) - 1, 0).r; }
