// The air before a picture with enough steps to converge, and random walks for multiple scattering.
#define IN_PARTS
#include "10_atmosphere/look.glsl"
#include "10_atmosphere/sun_marched.glsl"
#include "10_atmosphere/in_scatter.glsl"
#include "10_atmosphere/path_parts.glsl"
#include "10_atmosphere/random_paths.glsl"

layout(rgba16f) writeonly uniform image2D doubt;  // the light's standard error, over the light
layout(scalar) uniform SeedBlock { uint seed; };

int light_steps() { return 48; }
bool light_steps_grow() { return true; }

Along along(Path path, vec3 direction, ivec2 pixel, float distance) {
    SoFar found = so_far(pixel);
#if ATMOSPHERE_ORDERS == ATMOSPHERE_ORDERS_MULTIPLE
    if (part.first_walk < part.end_walk) {
        start_random(uvec2(pixel), seed + 65537u * uint(part.first_walk));
        Path piece = between(path, part.first_walk, part.end_walk, atmosphere.paths);
        vec3 often = scattered_often(piece, part.end_walk - part.first_walk, found.through.rgb, found.light.a);
        found.light.rgb += often;
        found.through.a += often.r + often.g + often.b;
    }
#endif
    add_places(found, path, 32 * atmosphere.steps);
#if ATMOSPHERE_ORDERS == ATMOSPHERE_ORDERS_MULTIPLE
    // Walks begin one in each part of the path: their sum varies less than this, which takes them for a random choice.
    float sum = found.through.a, n = float(atmosphere.paths), all = found.light.r + found.light.g + found.light.b;
    float deviation = sqrt(max(found.light.a - sum * sum / n, 0.0) * n / max(n - 1.0, 1.0));
    if (part.ends != 0) imageStore(doubt, pixel, vec4(deviation / max(all, 1e-9)));
#endif
    keep(found, pixel);
    return Along(found.light.rgb, found.through.rgb);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
#if ATMOSPHERE_ORDERS == ATMOSPHERE_ORDERS_MULTIPLE
    if (part.ends != 0) imageStore(doubt, pixel, vec4(0.0));
#endif
    look(pixel);
}
