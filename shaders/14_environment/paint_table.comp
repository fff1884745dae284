// Car paint over (n·l, n·v): its BRDF per steradian, a texel for each pair of cosines, and below it, in two more rows, what
// pigment and flakes send back in all to each n·v.
#include "14_environment/paint_data.h"
#include "14_environment/paint_model.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) writeonly uniform image2D table;

float cosine_of(int texel) { return max(float(texel) / float(PAINT_TEXELS - 1), 1e-3); }

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (texel.x >= PAINT_TEXELS || texel.y >= PAINT_TEXELS + 2) return;
    float n_dot_v = cosine_of(texel.x);
    vec3 found = vec3(0.0);
    if (texel.y < PAINT_TEXELS) {
        float n_dot_l = cosine_of(texel.y);
        found = through_coat(n_dot_l, n_dot_v) * (mix(pigment_brdf(n_dot_l, n_dot_v),
                                                      flake_brdf(n_dot_l, n_dot_v) * paint.flake_color, paint.flakes));
    } else {
        const int steps = 64;
        for (int i = 0; i < steps; ++i) {
            float n_dot_l = (float(i) + 0.5) / float(steps);
            vec3 layer = texel.y == PAINT_TEXELS ? (1.0 - paint.flakes) * pigment_brdf(n_dot_l, n_dot_v)
                                                 : paint.flakes * flake_brdf(n_dot_l, n_dot_v) * paint.flake_color;
            found += 2.0 * pi * n_dot_l / float(steps) * through_coat(n_dot_l, n_dot_v) * layer;
        }
    }
    imageStore(table, texel, vec4(found, 1.0));
}
