// Car paint over (n·l, n·v): its BRDF per steradian, a texel for each pair of cosines, and below it, in two more
// rows, the albedo of pigment and flakes for each n·v.
#include "14_environment/paint_data.h"
#include "14_environment/paint_model.glsl"
#include "14_environment/importance_sample_ggx.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) writeonly uniform image2D table;

float cosine_of(int texel) { return max(float(texel) / float(PAINT_TEXELS - 1), 1e-3); }

// Light that white flakes send to n·v under radiance 1 from everywhere: half vectors as dense as the lobe.
float flake_albedo(float n_dot_v) {
    float v = below_coat(n_dot_v), alpha = paint.flake_roughness * paint.flake_roughness, sum = 0.0;
    vec3 to_eye = vec3(sqrt(1.0 - v * v), 0.0, v);
    const uint samples = 256u;
    for (uint i = 0u; i < samples; ++i) {
        vec3 half_vector = importance_sample_ggx(hammersley(i, samples), alpha);
        float facing = dot(to_eye, half_vector);
        vec3 to_light = 2.0 * facing * half_vector - to_eye;
        float across = coat_index * coat_index * dot(to_light.xy, to_light.xy);  // sine squared, above the coat
        if (facing <= 0.0 || to_light.z <= 0.0 || across >= 1.0) continue;       // reflected back into the paint
        sum += 4.0 * facing * to_light.z / half_vector.z * ggx_visibility(to_light.z, v, alpha) *
               through_coat(sqrt(1.0 - across), n_dot_v);
    }
    return sum / float(samples);
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (texel.x >= PAINT_TEXELS || texel.y >= PAINT_TEXELS + 2) return;
    float n_dot_v = cosine_of(texel.x);
    vec3 found = vec3(0.0);
    if (texel.y < PAINT_TEXELS) {
        float n_dot_l = cosine_of(texel.y);
        found = through_coat(n_dot_l, n_dot_v) * (mix(pigment_brdf(n_dot_l, n_dot_v),
                                                      flake_brdf(n_dot_l, n_dot_v) * paint.flake_color, paint.flakes));
    } else if (texel.y == PAINT_TEXELS) {
        const int steps = 64;
        for (int i = 0; i < steps; ++i) {
            float n_dot_l = (float(i) + 0.5) / float(steps);
            found += 2.0 * pi * n_dot_l / float(steps) * through_coat(n_dot_l, n_dot_v) * (1.0 - paint.flakes) *
                     pigment_brdf(n_dot_l, n_dot_v);
        }
    } else {
        found = paint.flakes * flake_albedo(n_dot_v) * paint.flake_color;
    }
    imageStore(table, texel, vec4(found, 1.0));
}
