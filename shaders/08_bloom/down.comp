// A level of the pyramid from the one above.
#include "08_bloom/down_filter.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (!is_outside(texel)) put(texel, down_filter(place_of(texel)));
}
