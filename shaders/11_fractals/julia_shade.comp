// What the pixels see: the set, lit by one light and by all that is around it, or what is around it alone.
#include "common/structs.h"
#include "02_lambert_phong/lambert.glsl"
#include "02_lambert_phong/phong.glsl"
#include "11_fractals/environment.glsl"
#include "11_fractals/fresnel.glsl"
#include "11_fractals/julia_normal.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D found;
layout(scalar) uniform JuliaLookBlock {
    vec3 color, color_deep, mirror;
    float shininess, gloss, facing, fresnel_power, background_level;
} julia_look;
layout(rgba16f) writeonly uniform image2D result;

// How near the orbit comes to the plane of the real numbers and i: points that are alike get a colour that is.
float orbit_trap(vec3 position) {
    vec4 z = julia_point(position);
    float nearest = 1e9;
    for (int i = 0; i < 12 && dot(z, z) < 16.0; ++i) {
        nearest = min(nearest, dot(z.zw, z.zw) + 0.25 * dot(z.xy, z.xy));
        z = quaternion_square(z) + julia_now.constant;
    }
    return sqrt(nearest);
}

// How much of what is around it a point sees: distances along the normal that are shorter than they would be above a
// plane (A. Evans, Fast approximations for global illumination on dynamic scenes, 2006). A distance here is about half.
float openness(vec3 position, vec3 normal) {
    float missing = 0.0, weight = 0.5;
    for (int i = 1; i <= 4; ++i) {
        float height = 0.02 * exp2(float(i));
        missing += weight * max(1.0 - 2.0 * julia_at(position + height * normal) / height, 0.0);
        weight *= 0.6;
    }
    return clamp(1.0 - missing, 0.0, 1.0);
}

float sunlit(vec3 position, vec3 normal) {
#if JULIA_SHADOW
    march_from = position + 0.003 * normal;
    march_along = julia_now.to_light;
    vec2 range = within_bound(march_from, march_along);
    March way = march(range.x, range.y, 5e-4, 2e-3, 1.0, 96);
    return float(way.ended == MARCH_MISS);
#else
    return 1.0;
#endif
}

// [shade]
vec3 shade(vec3 position, vec3 along) {
    vec3 normal = julia_normal(position, along), to_eye = -along;
    vec3 albedo = mix(julia_look.color_deep, julia_look.color, smoothstep(0.05, 0.6, orbit_trap(position)));
    float open = openness(position, normal);
    vec3 diffuse = environment_irradiance(normal) * open, specular = vec3(0.0);
    vec3 light = julia_now.light;
    float cosine = lambert(normal, julia_now.to_light);
    if (cosine > 0.0 && any(greaterThan(light, vec3(0.0)))) {
        light *= sunlit(position, normal);
        diffuse += light * cosine;
        specular = light * julia_look.gloss * phong(normal, julia_now.to_light, to_eye, julia_look.shininess);
    }
#if JULIA_FRESNEL == JULIA_FRESNEL_SCHLICK
    float mirrored = fresnel_schlick(dot(normal, to_eye), julia_look.facing);
#else
    float mirrored = fresnel_power(dot(normal, to_eye), julia_look.facing, julia_look.fresnel_power);
#endif
    vec3 reflection = environment_radiance(reflect(along, normal), 1.0) * open * julia_look.mirror;
    return mix(albedo / 3.14159265 * diffuse, reflection, mirrored) + specular;
}
// [/shade]

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    vec4 march = texelFetch(found, pixel, 0);
    vec3 along = pixel_direction(pixel), position = julia_now.rays.eye + march.x * along, shown;
    bool missed = int(march.z) == MARCH_MISS;
#if JULIA_SHOW == JULIA_SHOW_STEPS
    // 0 blue, half of the steps green, all of them red; what was stopped on its way is white.
    float share = clamp(march.y / float(julia.most_steps), 0.0, 1.0);
    shown = int(march.z) == MARCH_CAPPED ? vec3(1.0)
                                         : vec3(smoothstep(0.3, 0.8, share), 4.0 * share * (1.0 - share), exp(-9.0 * share) * 0.35);
#elif JULIA_SHOW == JULIA_SHOW_NORMALS
    shown = missed ? vec3(0.0) : 0.5 + 0.5 * julia_normal(position, along);
#else
    shown = missed ? environment_radiance(along, julia_look.background_level) : shade(position, along);
#endif
    imageStore(result, pixel, vec4(min(shown, LARGEST_HALF), 1.0));
}
