// A pixel's surface, as far as lighting needs it.
#include "common/structs.h"

// [pixel]
struct PixelMaterial {
    MixedMaterial mixed;
    float occlusion;         // of ambient light, 0 to 1
    float ambient_specular;  // 1 where ambient light is reflected by the specular colour, too; else 0
};

struct Pixel {
    vec3 normal;    // unit length, world space, with its bumps
    vec3 facing;    // unit length, world space: the normal of the mesh
    vec3 position;  // metres, world space
    PixelMaterial material;
};
// [/pixel]
