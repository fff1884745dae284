// A level of the pyramid from the one above.
#include "08_bloom/down_filter.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (!is_outside(texel)) put(texel, down_filter(place_of(texel)));
}
