// A face of a cube from a picture drawn of it. Faces of a cube are seen from outside (Vulkan 1.3, 16.5.4), and so
// mirrored.
#include "common/light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D picture;
layout(rgba16f) writeonly uniform image2D face;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(face);
    if (any(greaterThanEqual(texel, size))) return;
    vec3 light = texelFetch(picture, ivec2(size.x - 1 - texel.x, texel.y), 0).rgb;
    imageStore(face, texel, vec4(finite_light(light), 1.0));
}
