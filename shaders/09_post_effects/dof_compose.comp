// Composition: sharp picture, background blur over it, foreground blur on top.
#include "09_post_effects/dof_lens.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D depth;
uniform sampler2D far_field;
#if DOF_METHOD == DOF_METHOD_GATHER
uniform sampler2D near_field;
#endif
layout(rgba16f) uniform image2D hdr;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(hdr)))) return;
    vec4 sharp = imageLoad(hdr, pixel);
    vec2 uv = 0.5 * (vec2(pixel) + 0.5) / vec2(textureSize(far_field, 0));
    float disc_px = confusion(texelFetch(depth, pixel, 0).r);
    vec3 behind = textureLod(far_field, uv, 0.0).rgb;
#if DOF_METHOD == DOF_METHOD_GATHER
    vec3 color = mix(sharp.rgb, behind, smoothstep(1.0, 3.0, disc_px));
    vec4 front = textureLod(near_field, uv, 0.0);
    color = color * (1.0 - front.a) + front.rgb;
#else
    // As it was first taught: one blurred picture, mixed in by how far out of focus the pixel is.
    vec3 color = mix(sharp.rgb, behind, min(abs(disc_px) / max(dof_now.wide_px, 1.0), 1.0));
#endif
    imageStore(hdr, pixel, vec4(color, sharp.a));
}
