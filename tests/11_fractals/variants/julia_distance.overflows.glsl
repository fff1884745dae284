// right, in its pictures too
#include "11_fractals/quaternion_square.glsl"

float julia_distance(vec4 z, vec4 c, int iterations, float escape) {
    float square = dot(z, z), slope_square = 1.0;  // |z|² and |z'|²
    for (int i = 0; i < iterations && square <= escape * escape; ++i) {
        slope_square *= 4.0 * square;
        z = quaternion_square(z) + c;
        square = dot(z, z);
    }
    if (square <= escape * escape) return 0.0;
    return slope_square > 0.0 ? 0.25 * sqrt(square / slope_square) * log(square) : 0.05;
}
