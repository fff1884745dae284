// For tests of 04.parallax_occlusion: fields with known intersections.
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

#include "04_surface_maps/parallax_occlusion.glsl"
