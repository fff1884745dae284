// The numbers that this chapter's shaders take from the module Maps.
layout(scalar) uniform MapsBlock {
    float height_m;  // how deep the darkest texel of a height map lies
    float displacement_m;  // how far the darkest texel of a displacement map lies below the brightest
    int steps;
    float strength;
    float detail_tiles;
    float cutoff;
    float wobble;  // tiles
    float scroll;  // tiles per second
} maps;
