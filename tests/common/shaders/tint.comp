// Colours a picture; the example of docs/framework.md.
// [tint_shader]
#include "../tests/common/shaders/tint.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) uniform TintBlock { float strength; } tint;  // the knob of the module `tint`
layout(scalar) uniform PigmentBlock { Pigment pigment; };   // pass.set("pigment", …)
uniform sampler2D from;                                     // stated in reads
layout(rgba16f) writeonly uniform image2D into;             // stated in writes

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(into)))) return;
    vec3 light = texelFetch(from, pixel, 0).rgb;
#if TINT_METHOD == TINT_METHOD_MULTIPLY
    vec3 tinted = light * pigment.color;
#else
    vec3 tinted = mix(light, pigment.color, pigment.share);
#endif
    imageStore(into, pixel, vec4(mix(light, tinted, tint.strength), 1.0));
}
// [/tint_shader]
