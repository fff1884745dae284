// Car paint over (n·l, n·v): its BRDF per steradian, a texel for each pair of cosines, and below it, in two more
// rows, the albedo of pigment and flakes for each n·v. Of measured paint, the first has what the fit's flakes leave.
#include "14_environment/measured_brdf.glsl"
#include "14_environment/paint_data.h"
#include "14_environment/paint_model.glsl"
#include "14_environment/importance_sample_ggx.glsl"

#define READS_MEASURED (PAINT_METHOD == PAINT_METHOD_AVERAGED || PAINT_METHOD == PAINT_METHOD_MEASURED)

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) writeonly uniform image2D table;

float cosine_of(int texel) { return max(float(texel) / float(PAINT_TEXELS - 1), 1e-3); }

// Light that white flakes send to n·v under radiance 1 from everywhere: half vectors as dense as the lobe.
float flake_albedo(float n_dot_v) {
    float v = below_coat(n_dot_v), alpha = paint_layers.flake_roughness * paint_layers.flake_roughness, sum = 0.0;
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

vec3 flakes_albedo(float n_dot_v) { return paint_layers.flakes * flake_albedo(n_dot_v) * paint_layers.flake_color; }

// Pigment and flakes, the mean over the angle between the two planes.
vec3 mean_brdf(float n_dot_l, float n_dot_v) {
#if READS_MEASURED
    float across = sqrt((1.0 - n_dot_l * n_dot_l) * (1.0 - n_dot_v * n_dot_v));
    vec3 sum = vec3(0.0);
    const int angles = 128;
    for (int i = 0; i < angles; ++i)
        sum += measured_brdf(n_dot_l, n_dot_v, n_dot_l * n_dot_v + across * cos(pi * (float(i) + 0.5) / float(angles)));
    return sum / float(angles);
#else
    return through_coat(n_dot_l, n_dot_v) *
           (mix(pigment_brdf(n_dot_l, n_dot_v), flake_brdf(n_dot_l, n_dot_v) * paint_layers.flake_color,
                paint_layers.flakes));
#endif
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (texel.x >= PAINT_TEXELS || texel.y >= PAINT_TEXELS + 2) return;
    float n_dot_v = cosine_of(texel.x);
    vec3 found = vec3(0.0);
    if (texel.y < PAINT_TEXELS) {
        found = mean_brdf(cosine_of(texel.y), n_dot_v);
    } else if (texel.y == PAINT_TEXELS) {
        const int steps = 64;
        for (int i = 0; i < steps; ++i) {
            float n_dot_l = (float(i) + 0.5) / float(steps);
#if READS_MEASURED
            found += 2.0 * pi * n_dot_l / float(steps) * mean_brdf(n_dot_l, n_dot_v);
        }
        found = max(found - flakes_albedo(n_dot_v), 0.0);
#else
            found += 2.0 * pi * n_dot_l / float(steps) * through_coat(n_dot_l, n_dot_v) * (1.0 - paint_layers.flakes) *
                     pigment_brdf(n_dot_l, n_dot_v);
        }
#endif
    } else {
        found = flakes_albedo(n_dot_v);
    }
    imageStore(table, texel, vec4(found, 1.0));
}
