// The air before a picture with so many steps that more of them change nothing that is seen, and random walks for what is
// scattered more than once.
#include "10_atmosphere/look.glsl"
#include "10_atmosphere/sun_marched.glsl"
#include "10_atmosphere/in_scatter.glsl"
#include "10_atmosphere/random_paths.glsl"

layout(rgba16f) writeonly uniform image2D doubt;  // the light's standard error, over the light
layout(scalar) uniform SeedBlock { uint seed; };

int light_steps() { return 48; }
bool light_steps_grow() { return true; }

// [along]
Along along(Path path, vec3 direction, ivec2 pixel, float distance) {
    Along result = in_scatter(32 * atmosphere.steps, path);
#if ATMOSPHERE_ORDERS == ATMOSPHERE_ORDERS_MULTIPLE
    start_random(uvec2(pixel), seed);
    float squares, once = result.light.r + result.light.g + result.light.b;
    vec3 often = scattered_often(path, atmosphere.paths, squares);
    // Walks begin one in each part of the path: their sum varies less than this, which takes them for a random choice.
    float sum = often.r + often.g + often.b, n = float(atmosphere.paths);
    float deviation = sqrt(max(squares - sum * sum / n, 0.0) * n / max(n - 1.0, 1.0));
    imageStore(doubt, pixel, vec4(deviation / max(once + sum, 1e-9)));
    result.light += often;
#endif
    return result;
}
// [/along]

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
#if ATMOSPHERE_ORDERS == ATMOSPHERE_ORDERS_MULTIPLE
    imageStore(doubt, pixel, vec4(0.0));
#endif
    look(pixel);
}
