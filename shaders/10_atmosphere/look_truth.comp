// The air before a picture, with so many steps that more of them change nothing that is seen.
#include "10_atmosphere/look.glsl"
#include "10_atmosphere/sun_marched.glsl"
#include "10_atmosphere/in_scatter.glsl"

int light_samples() { return 48; }
bool light_steps_grow() { return true; }

Along along(Path path, vec3 direction, ivec2 pixel, float distance) { return in_scatter(path, 32 * atmosphere.samples); }

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(result)))) look(pixel);
}
