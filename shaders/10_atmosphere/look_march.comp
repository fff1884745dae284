// The air before a picture, by marching each pixel's path and, from each of its places, to the sun.
#include "10_atmosphere/look.glsl"
#include "10_atmosphere/sun_marched.glsl"
#include "10_atmosphere/in_scatter.glsl"
#include "10_atmosphere/path_parts.glsl"

int light_steps() { return atmosphere.light_steps; }
bool light_steps_grow() { return false; }

Along along(Path path, vec3 direction, ivec2 pixel, float distance) {
#ifdef IN_PARTS
    SoFar found = so_far(pixel);
    add_places(found, path, atmosphere.steps);
    keep(found, pixel);
    return Along(found.light.rgb, found.through.rgb);
#else
    return in_scatter(atmosphere.steps, path);
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(result)))) look(pixel);
}
