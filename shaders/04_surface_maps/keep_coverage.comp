// Alpha scaling of one mip, so that as large a share passes the test as in level 0; one workgroup.
layout(local_size_x = 256) in;

layout(rgba32f) uniform image2D level;
layout(scalar) uniform CutoutBlock {
    float cutoff;
    float wanted;  // share in level 0
} cutout;

// Interface of alpha_scale.glsl.
const uint LEVEL_INVOCATIONS = 256u;

ivec2 place_of(uint texel) { return ivec2(texel % uint(imageSize(level).x), texel / uint(imageSize(level).x)); }
uint level_texels() { return uint(imageSize(level).x * imageSize(level).y); }
float level_alpha(uint texel) { return imageLoad(level, place_of(texel)).a; }
bool is_kept(float alpha) { return round(255.0 * min(alpha, 1.0)) / 255.0 >= cutout.cutoff; }

#include "04_surface_maps/alpha_scale.glsl"

void main() {
    uint local = gl_LocalInvocationIndex;
    float scale = alpha_scale(local, cutout.cutoff, cutout.wanted);
    barrier();  // before any alpha changes
    for (uint i = local; i < level_texels(); i += LEVEL_INVOCATIONS) {
        vec4 texel = imageLoad(level, place_of(i));
        imageStore(level, place_of(i), vec4(texel.rgb, min(1.0, texel.a * scale)));
    }
}
