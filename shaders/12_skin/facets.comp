// The specular terms as a table of 8 bits: see encode_facets().
#include "12_skin/skin.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8) writeonly uniform image2D result;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(texel, size))) return;
    vec2 at = vec2(texel) / vec2(size - 1);
    float rise = schlick_fresnel(at.x, 0.0);
    imageStore(result, texel, vec4(encode_facets(beckmann(at.x, max(at.y, 0.5 / float(size.y)))), rise, 0.0, 1.0));
}
