// How much of the light from one direction the surface reflects as by facets: over the cosine along u, over m along v. And
// the mean of that over all directions.
#include "12_skin/schlick_fresnel.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;
layout(scalar) uniform F0Block { float f0; };

const int facets_u = 32, facets_v = 16;

// Facets are sampled by their density: then the estimate is F(v·h) n·l / (v·h n·h) for any m.
float reflected(float cosine, float m) {
    vec3 v = vec3(sqrt(max(1.0 - cosine * cosine, 0.0)), 0.0, cosine);
    float sum = 0.0;
    for (int i = 0; i < facets_u; ++i) {
        float u = (float(i) + 0.5) / float(facets_u);
        float tan2 = -m * m * log(1.0 - u), cos_h = inversesqrt(1.0 + tan2), sin_h = sqrt(max(1.0 - cos_h * cos_h, 0.0));
        for (int j = 0; j < facets_v; ++j) {
            float angle = 6.2831853 * (float(j) + 0.5) / float(facets_v);
            vec3 h = vec3(sin_h * cos(angle), sin_h * sin(angle), cos_h);
            float v_dot_h = dot(v, h);
            if (v_dot_h <= 0.0) continue;
            float n_dot_l = 2.0 * v_dot_h * h.z - v.z;
            if (n_dot_l > 0.0) sum += schlick_fresnel(v_dot_h, f0) * n_dot_l / (v_dot_h * h.z);
        }
    }
    return min(sum / float(facets_u * facets_v), 1.0);
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(texel, size))) return;
    vec2 at = vec2(texel) / vec2(size - 1);
    float m = max(at.y, 0.01), mean = 0.0;
    const int steps = 16;
    for (int i = 0; i < steps; ++i) {
        float cosine = (float(i) + 0.5) / float(steps);
        mean += 2.0 * cosine * reflected(cosine, m) / float(steps);
    }
    imageStore(result, texel, vec4(reflected(max(at.x, 0.01), m), mean, 0.0, 1.0));
}
