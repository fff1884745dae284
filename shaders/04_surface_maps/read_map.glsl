// A look-up in a surface map, filtered over the pixel's footprint.
#include "common/structs.h"
#include "04_surface_maps/anisotropy.glsl"

struct Coordinates {
    vec2 uv, dx, dy;  // and their screen-space derivatives
};

// Explicit level instead of textureGrad, which devices may approximate, as Mesa 22.3 does.
#if MAPS_ANISOTROPY == MAPS_ANISOTROPY_1
vec4 read(sampler2D map, Coordinates at) {
    vec2 size = vec2(textureSize(map, 0)), dx = at.dx * size, dy = at.dy * size;
    float texels = max(max(dot(dx, dx), dot(dy, dy)), 1e-12);  // texels per pixel, squared
    return textureLod(map, image_uv(at.uv), 0.5 * log2(texels));
}
#else
// [read_along]
// The options of MAPS_ANISOTROPY are powers of two. A sampler's own anisotropy has no effect on an explicit level.
vec4 read(sampler2D map, Coordinates at) {
    vec2 size = vec2(textureSize(map, 0));
    vec4 along = footprint_reads(at.dx * size, at.dy * size, float(1 << MAPS_ANISOTROPY));
    vec4 sum = vec4(0.0);
    for (float i = 0.5; i < along.z; ++i)
        sum += textureLod(map, image_uv(at.uv + (i / along.z - 0.5) * along.xy / size), along.w);
    return sum / along.z;
}
// [/read_along]
#endif
