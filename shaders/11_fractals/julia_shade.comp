// The pixels' view: the set, lit by one light and by its surroundings, or the surroundings alone.
#include "common/structs.h"
#include "02_lambert_phong/lambert.glsl"
#include "02_lambert_phong/phong.glsl"
#include "common/environment.glsl"
#include "11_fractals/julia.glsl"
#include "common/schlick.glsl"

// The normal of a Julia set's surroundings: the direction in which the distance grows.

// First-order change of z² if z becomes z + q: z q + q z, over 2.
vec4 square_change(vec4 z, vec4 q) { return vec4(z.x * q.x - dot(z.yzw, q.yzw), q.x * z.yzw + z.x * q.yzw); }

// [analytic]
// The gradient of |z| after all turns, by the chain rule: how z changes as the point moves along x, y and z. Its length is
// of no use. So each iteration divides by |z|, and nothing overflows.
vec3 julia_gradient(vec3 position) {
    vec4 z = julia_point(position);
    vec4 by_x = vec4(1.0, 0.0, 0.0, 0.0), by_y = vec4(0.0, 1.0, 0.0, 0.0), by_z = vec4(0.0, 0.0, 1.0, 0.0);
    for (int i = 0; i < julia.iterations; ++i) {
        float square = dot(z, z);
        if (square > julia.escape * julia.escape || square < 1e-20) break;  // a hit within the set may run into 0
        float scale = inversesqrt(square);
        by_x = scale * square_change(z, by_x);
        by_y = scale * square_change(z, by_y);
        by_z = scale * square_change(z, by_z);
        z = quaternion_square(z) + julia_now.constant;
    }
    return vec3(dot(z, by_x), dot(z, by_y), dot(z, by_z));
}
// [/analytic]

vec3 julia_difference(vec3 position) {
    vec2 h = vec2(julia.difference_m, 0.0);
    return vec3(julia_at(position + h.xyy) - julia_at(position - h.xyy),
                julia_at(position + h.yxy) - julia_at(position - h.yxy),
                julia_at(position + h.yyx) - julia_at(position - h.yyx));
}

// Unit length. Where the distance grows nowhere, as within the set, it faces the ray.
vec3 julia_normal(vec3 position, vec3 along) {
#if JULIA_NORMAL == JULIA_NORMAL_ANALYTIC
    vec3 gradient = julia_gradient(position);
#else
    vec3 gradient = julia_difference(position);
#endif
    float largest = max(abs(gradient.x), max(abs(gradient.y), abs(gradient.z)));
    return largest > 0.0 ? normalize(gradient / largest) : -along;
}

// Reflectance 1 - cosine^k, scaled to run from `facing` to 1: no physics, but a rim as wide as one likes.
float fresnel_power(float cosine, float facing, float k) {
    float clamped = clamp(cosine, 0.0, 1.0);
    return facing + (1.0 - facing) * (clamped > 0.0 ? 1.0 - pow(clamped, k) : 1.0);
}

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

// Ambient visibility of a point: distances along the normal that are shorter than above a plane (A. Evans, Fast
// approximations for global illumination on dynamic scenes, 2006). A distance here is about half.
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
    float mirrored = schlick(dot(normal, to_eye), julia_look.facing);
#else
    float mirrored = fresnel_power(dot(normal, to_eye), julia_look.facing, julia_look.fresnel_power);
#endif
    vec3 reflection = environment_radiance(reflect(along, normal), 1.0) * open * julia_look.mirror;
    return mix(albedo / 3.14159265 * diffuse, reflection, mirrored) + specular;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    vec4 march = texelFetch(found, pixel, 0);
    vec3 along = pixel_direction(pixel), position = julia_now.rays.eye + march.x * along, shown;
    bool missed = int(march.z) == MARCH_MISS;
#if JULIA_SHOW == JULIA_SHOW_STEPS
    // 0 blue, half of the steps green, all of them red; rays stopped early are white.
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
