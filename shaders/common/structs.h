// Structs written once and read by GLSL and C++ alike. In GLSL they lie in buffers with scalar layout, which packs
// members without padding, as C++ packs glm's vectors.
#ifndef LIGHTWALK_STRUCTS_H
#define LIGHTWALK_STRUCTS_H
#include "common/shared.h"

BEGIN_SHARED

struct Vertex {
    vec3 position;  // metres, object space
    vec3 normal;    // unit length
    vec2 uv;        // v = 0 is the bottom row of an image
};

END_SHARED
#endif
