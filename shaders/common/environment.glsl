// Light from all around: radiance along a direction, and irradiance of a surface. A pass that states the module
// EnvironmentLight in `.with` has them.
uniform samplerCube environment_cube;
uniform samplerCube environment_irradiance_cube;
layout(scalar) uniform EnvironmentScaleBlock {  // EnvironmentScale of common/app/environment.h
    float cosine, sine;                         // of the turn about +y, counter-clockwise seen from above
    float intensity;                            // scale factor of radiance and irradiance
} environment_scale;

// From world space to the picture's.
vec3 environment_space(vec3 direction) {
    vec2 xz = mat2(environment_scale.cosine, environment_scale.sine, -environment_scale.sine, environment_scale.cosine) *
              direction.xz;
    return vec3(xz.x, direction.y, xz.y);
}

// Radiance from `direction` (world space, any length above 0), RGB; level 0 is sharp, each further level averages
// over texels twice as wide, which are 0.35° in level 0.
vec3 environment_radiance(vec3 direction, float level) {
    return environment_scale.intensity * textureLod(environment_cube, environment_space(direction), level).rgb;
}

// Irradiance of a surface with that normal (world space), RGB: the integral of radiance times cosine over the
// hemisphere. A Lambertian surface of albedo a emits a / pi times this.
vec3 environment_irradiance(vec3 normal) {
    return environment_scale.intensity * textureLod(environment_irradiance_cube, environment_space(normal), 0.0).rgb;
}

// In the units of the lights: radiance of a matt white surface with that normal.
vec3 surroundings_light(vec3 normal) { return environment_irradiance(normal) / 3.14159265; }

// Reflection in facets of that slope: a level with texels as wide as they spread a ray.
vec3 surroundings_mirrored(vec3 direction, float m) {
    float texel = 1.5707963 / float(textureSize(environment_cube, 0).x);
    return environment_radiance(direction, max(log2(2.0 * m / texel), 0.0));
}
