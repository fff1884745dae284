// Fills the gaps between samples with a mean over the area of one sample.
#include "09_post_effects/dof_disc.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar) uniform DofBlock { int taps; } dof;
uniform sampler2D half_picture;
uniform sampler2D reached;
uniform sampler2D far_field;
uniform sampler2D near_field;
layout(rgba16f) writeonly uniform image2D far_result;
layout(rgba16f) writeonly uniform image2D near_result;
const int around = 12;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(far_result)))) return;
    vec2 size = vec2(imageSize(far_result)), middle = (vec2(at) + 0.5) / size;
    float spacing = 1.2 * inversesqrt(float(dof.taps));  // of a disc's radius
    float own = texelFetch(half_picture, at, 0).a;
    vec4 behind = textureLod(far_field, middle, 0.0), front = textureLod(near_field, middle, 0.0);
    vec2 widest = 0.25 * texelFetch(reached, at / 8, 0).rg;
    for (int i = 0; i < around; ++i) {
        vec2 place = on_disc(i, around, 0.0);
        vec2 there = middle + spacing * 0.25 * max(own, 0.0) * place / size;
        // No reads across the edge of an equally blurred region.
        float other = textureLod(half_picture, there, 0.0).a;
        if (other > 0.5 * own) behind += vec4(textureLod(far_field, there, 0.0).rgb, 1.0);
        front += textureLod(near_field, middle + spacing * widest.x * place / size, 0.0);
    }
    imageStore(far_result, at, behind / behind.a);
    imageStore(near_result, at, front / float(around + 1));
}
