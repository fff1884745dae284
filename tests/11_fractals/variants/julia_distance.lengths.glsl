// right, in its pictures too
#include "11_fractals/quaternion_square.glsl"

float julia_distance(vec4 z, vec4 c, int iterations, float escape) {
    float slope = 1.0;
    for (int i = 0; i < iterations; ++i) {
        if (length(z) > escape) break;
        slope *= 2.0 * length(z);
        if (slope > 1e15) return 0.0;
        z = quaternion_square(z) + c;
    }
    float size = length(z);
    if (size <= escape) return 0.0;
    if (slope == 0.0) return 0.05;
    return 0.5 * size / slope * log(size);
}
