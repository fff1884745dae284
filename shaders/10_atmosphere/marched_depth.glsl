// Optical depth of a ray out of the air, by marching: `samples` equal steps, or steps that grow with the distance, because
// the air is densest at one end.
#include "10_atmosphere/air.glsl"

vec3 marched_depth(float height, float slope, int samples, bool grow) {
    float way = ray_sphere(height, slope, air.radius, air.top).y;
    vec3 depth = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        float from = float(i) / float(samples), to = float(i + 1) / float(samples);
        if (grow) {
            from *= from;
            to *= to;
        }
        depth += (to - from) * way * extinction(density_at(height_at(height, slope, 0.5 * (from + to) * way)));
    }
    return depth;
}
