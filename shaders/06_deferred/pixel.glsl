// Surface of a pixel, for lighting.
#include "common/structs.h"

struct PixelMaterial {
    MixedMaterial mixed;
    float occlusion;         // visibility of ambient light, 0 to 1
    float ambient_specular;  // 1: the specular colour reflects ambient light too; else 0
};

struct Pixel {
    vec3 normal;    // shading normal, unit length, world space
    vec3 facing;    // mesh normal, unit length, world space
    vec3 plane;     // normal of the triangle, unit length, world space
    vec3 position;  // metres, world space
    PixelMaterial material;
};
