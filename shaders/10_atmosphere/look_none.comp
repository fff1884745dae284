// A picture without air: the sun's disc alone.
#include "10_atmosphere/look.glsl"

Along along(Path path, vec3 direction, ivec2 pixel, float distance) { return Along(vec3(0.0), vec3(1.0)); }

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(result)))) look(pixel);
}
