// Environment light: radiance along a direction, irradiance of a surface. For passes with the module EnvironmentLight
// in `.with`.
uniform samplerCube environment_cube;
uniform samplerCube environment_irradiance_cube;
layout(scalar) uniform EnvironmentScaleBlock {  // EnvironmentScale of common/app/environment.h
    float cosine, sine;                         // rotation about +y, counter-clockwise seen from above
    float intensity;                            // scale factor of radiance and irradiance
} environment_scale;

// World space to environment space.
vec3 environment_space(vec3 direction) {
    vec2 xz = mat2(environment_scale.cosine, environment_scale.sine, -environment_scale.sine, environment_scale.cosine) *
              direction.xz;
    return vec3(xz.x, direction.y, xz.y);
}

// Radiance from `direction` (world space, any length above 0). Each level doubles the texel's width, 0.35° in level 0.
vec3 environment_radiance(vec3 direction, float level) {
    return environment_scale.intensity * textureLod(environment_cube, environment_space(direction), level).rgb;
}

// Irradiance for a world-space normal: integral of radiance times cosine over the hemisphere. A Lambertian surface of
// albedo a emits a / pi times this.
vec3 environment_irradiance(vec3 normal) {
    return environment_scale.intensity * textureLod(environment_irradiance_cube, environment_space(normal), 0.0).rgb;
}

// Irradiance over pi: radiance of a white Lambertian surface.
vec3 surroundings_light(vec3 normal) { return environment_irradiance(normal) / 3.14159265; }

// Radiance reflected by facets of this slope, from the level whose texels are as wide as the reflected cone.
vec3 surroundings_mirrored(vec3 direction, float m) {
    float texel = 1.5707963 / float(textureSize(environment_cube, 0).x);
    return environment_radiance(direction, max(log2(2.0 * m / texel), 0.0));
}
