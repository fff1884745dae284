// Light from all around, in the units of the lights.
#include "11_fractals/environment.glsl"

// What a matt white surface with that normal shows of it.
vec3 surroundings_light(vec3 normal) { return environment_irradiance(normal) / 3.14159265; }

// What is seen in a mirror whose facets have that slope: a level whose texels are as wide as they spread a ray.
vec3 surroundings_mirrored(vec3 direction, float m) {
    float texel = 1.5707963 / float(textureSize(environment_cube, 0).x);
    return environment_radiance(direction, max(log2(2.0 * m / texel), 0.0));
}
