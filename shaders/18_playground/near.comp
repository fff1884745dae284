// Picked item of a click.
#include "18_playground/id_buffer.glsl"

layout(local_size_x = 1) in;
layout(scalar) uniform AskedBlock { ivec3 asked; };  // pixel, reach
layout(scalar) writeonly buffer ResultBuffer { uint result[]; };

void main() {
    uint id = id_near(asked.xy, asked.z);
    result[0] = id;
    result[1] = id == 0u ? 0u : item_of(id);
}
