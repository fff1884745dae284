// The surface that a height map stands for. Depth 0 is the mesh, 1 the deepest point. Between the middles of four texels
// the depth is bilinear, at full resolution: this one surface is what every method looks for.
#include "common/image_uv.glsl"

#ifdef FIELD
// For tests: fields whose intersections are known.
float depth_at(vec2 uv) {
#if FIELD == 1
    return fract(uv.x);                          // a ramp
#elif FIELD == 2
    return 0.5 + 0.5 * sin(6.2831853 * uv.x);    // a wave
#elif FIELD == 3
    return abs(uv.x - 0.5) < 1.0 / 512.0 ? 0.0 : 1.0;  // one texel that sticks out of a floor
#else
    return 0.5;                                  // a plane half-way down
#endif
}
#else
uniform sampler2D height_map;

float depth_at(vec2 uv) { return 1.0 - textureLod(height_map, image_uv(uv), 0.0).r; }
#endif
