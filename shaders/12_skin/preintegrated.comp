// E. Penner and G. Borshukov, "Pre-Integrated Skin Shading", GPU Pro 2, 2011: the radiance of a sphere of skin in one
// light, over the cosine to it along u and the sphere's curvature along v. They integrate along a circle; here over
// the sphere.
#include "12_skin/gaussian_profile.glsl"
#include "12_skin/profile.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;

const int rings = 96, parts = 24;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(texel, size))) return;
    float cosine = -1.0 + 2.0 * float(texel.x) / float(size.x - 1), sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    float radius = 1.0 / curvature_at(max(float(texel.y), 0.25) / float(size.y - 1));
    // Rings around the point, denser near it; no light comes from farther than 9 mm.
    float widest = radius < 4.5 ? 3.14159265 : 2.0 * asin(4.5 / radius);
    vec3 sum = vec3(0.0), all = vec3(0.0);
    for (int i = 0; i < rings; ++i) {
        float from = float(i) / float(rings), to = float(i + 1) / float(rings);
        float angle = widest * (0.5 * (from * from * from + to * to * to)), width = widest * (to * to * to - from * from * from);
        vec3 weight = gaussian_profile(2.0 * radius * sin(0.5 * angle)) * sin(angle) * width;
        float light = 0.0;
        for (int j = 0; j < parts; ++j) {
            float around = 6.2831853 * (float(j) + 0.5) / float(parts);
            light += max(cos(angle) * cosine + sin(angle) * sine * cos(around), 0.0);
        }
        sum += weight * light / float(parts);
        all += weight;
    }
    imageStore(result, texel, vec4(sum / all, 1.0));
}
