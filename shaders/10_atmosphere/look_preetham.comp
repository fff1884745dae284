// The sky of a formula behind a picture; no air before the objects.
#include "10_atmosphere/look.glsl"
#include "10_atmosphere/preetham.glsl"

Along along(Path path, vec3 direction, ivec2 pixel, float distance) {
    if (distance < endless) return Along(vec3(0.0), vec3(1.0));
    return Along(atmosphere.exposure * preetham_sky(direction, to_sun, atmosphere.turbidity),
                 preetham_sunlight(direction, atmosphere.turbidity));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(result)))) look(pixel);
}
