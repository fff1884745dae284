// Image-based light: the module ImageLight for shaders.
#include "common/environment.glsl"
#include "14_environment/box_project.glsl"
#include "14_environment/ggx.glsl"
#include "14_environment/image_light_data.h"

uniform samplerCube image_light_radiance;     // all levels: means of 2x2 texels
uniform samplerCube image_light_prefiltered;  // all levels: by roughness
uniform samplerCube image_light_irradiance;   // over pi
uniform sampler2D image_light_table;          // the split sum: A and B over n·v and alpha
layout(scalar) readonly buffer ImageLightShBuffer { vec4 image_light_sh[]; };
layout(scalar) uniform ImageLightStateBlock { ImageLightState image_light_state; };

// A surface as this light sees it.
struct LitFromAround {
    vec3 position;  // metres, world space
    vec3 normal;    // unit length, world space
    vec3 to_eye;    // unit length, world space
    vec3 f0;        // reflectance at normal incidence
    float alpha;    // GGX; the square of roughness
    Blend blend;    // coated and bare parts, of which f0 is the mean
};

// Into the cube's own space. Around a probe it depends on where the ray begins.
vec3 cube_space(vec3 position, vec3 direction) {
    if (image_light_state.has_box == 1u)
        direction = box_project(position, direction, image_light_state.box_lower, image_light_state.box_upper,
                                image_light_state.box_center);
    return environment_space(direction);
}

vec3 radiance_along(vec3 position, vec3 direction, float level) {
    return environment_scale.intensity * textureLod(image_light_radiance, cube_space(position, direction), level).rgb;
}

vec3 prefiltered_along(vec3 position, vec3 direction, float roughness) {
    float level = roughness * (image_light_state.levels - 1.0);
    return environment_scale.intensity *
           textureLod(image_light_prefiltered, cube_space(position, direction), level).rgb;
}

// Irradiance over pi from nine coefficients of radiance: R. Ramamoorthi and P. Hanrahan, "An Efficient Representation for
// Irradiance Environment Maps", SIGGRAPH 2001, equation 13, with its constants c1 to c5 over pi.
vec3 sh_irradiance(vec3 n) {
    const float c1 = 0.429043 / pi, c2 = 0.511664 / pi, c3 = 0.743125 / pi, c4 = 0.886227 / pi, c5 = 0.247708 / pi;
    vec3 light = c4 * image_light_sh[0].rgb + 2.0 * c2 * (image_light_sh[3].rgb * n.x + image_light_sh[1].rgb * n.y +
                                                           image_light_sh[2].rgb * n.z);
    light += c1 * image_light_sh[8].rgb * (n.x * n.x - n.y * n.y) + (c3 * n.z * n.z - c5) * image_light_sh[6].rgb;
    light += 2.0 * c1 * (image_light_sh[4].rgb * n.x * n.y + image_light_sh[7].rgb * n.x * n.z +
                         image_light_sh[5].rgb * n.y * n.z);
    return light;
}

// Irradiance over pi: the radiance of a white matt surface.
vec3 diffuse_light(vec3 position, vec3 normal) {
    vec3 n = environment_space(normal);
#if IMAGE_LIGHT_DIFFUSE == IMAGE_LIGHT_DIFFUSE_CONSTANT
    vec3 light = 0.282095 * image_light_sh[0].rgb;
#elif IMAGE_LIGHT_DIFFUSE == IMAGE_LIGHT_DIFFUSE_SH9
    vec3 light = sh_irradiance(n);
#else
    vec3 light = textureLod(image_light_irradiance, n, 0.0).rgb;
#endif
    return environment_scale.intensity * light;
}

// A and B of 14.environment_brdf.
vec2 split_sum_at(float n_dot_v, float alpha) {
    vec2 size = vec2(textureSize(image_light_table, 0));
    return textureLod(image_light_table, (vec2(n_dot_v, alpha) * (size - 1.0) + 0.5) / size, 0.0).rg;
}

// The direction from which most of a rough reflection comes: between the mirror's and the normal. S. Lagarde and C. de
// Rousiers, "Moving Frostbite to Physically Based Rendering", SIGGRAPH course, 2014, section 4.9.3.
vec3 dominant_direction(vec3 normal, vec3 mirrored, float alpha) {
    float smooth_share = clamp(1.0 - alpha, 0.0, 1.0);
    return mix(normal, mirrored, smooth_share * (sqrt(smooth_share) + alpha));
}

// Reflectance at n·v of a rough surface. The power: C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering",
// 1994. The limit at grazing angles, where most facets are not seen: S. Lagarde, "Adopting a physically based shading model",
// 2011.
vec3 schlick_roughness(float n_dot_v, vec3 f0, float roughness) {
    float grazing = clamp(1.0 - n_dot_v, 0.0, 1.0), square = grazing * grazing;
    return f0 + (max(vec3(1.0 - roughness), f0) - f0) * square * square * grazing;
}

struct FromAround {
    vec3 specular;       // radiance towards the eye
    vec3 diffuse_share;  // share of light that enters the coated part: 1 less the share that its coat reflects
    vec3 multiple;       // of `specular`: light that left the microfacets after more than one of them
};

#include "14_environment/sampled.glsl"

// Radiance that a surface reflects by its smooth coat of microfacets, by the method chosen.
FromAround reflected_from_around(LitFromAround s) {
    float n_dot_v = clamp(dot(s.normal, s.to_eye), 1e-3, 1.0), roughness = sqrt(s.alpha);
    vec3 mirrored = reflect(-s.to_eye, s.normal);
    FromAround r = FromAround(vec3(0.0), vec3(1.0), vec3(0.0));
#if IMAGE_LIGHT_METHOD == IMAGE_LIGHT_METHOD_MIRROR
    vec3 fresnel = schlick_roughness(n_dot_v, s.f0, roughness);
    r.specular = fresnel * radiance_along(s.position, mirrored, 0.0);
    r.diffuse_share = 1.0 - schlick_roughness(n_dot_v, s.blend.coat_f0, roughness);
#elif IMAGE_LIGHT_METHOD == IMAGE_LIGHT_METHOD_BOX_MIPS
    // The level with texels as wide as the lobe: half of its light lies within atan(alpha) of half vectors.
    vec3 fresnel = schlick_roughness(n_dot_v, s.f0, roughness);
    float level = log2(max(2.0 * atan(s.alpha) * image_light_state.texels / (0.5 * pi), 1.0));
    r.specular = fresnel * radiance_along(s.position, mirrored, level);
    r.diffuse_share = 1.0 - schlick_roughness(n_dot_v, s.blend.coat_f0, roughness);
#elif IMAGE_LIGHT_METHOD != IMAGE_LIGHT_METHOD_NONE
    vec2 ab = split_sum_at(n_dot_v, s.alpha);
    vec3 single = s.f0 * ab.x + ab.y;
    r.diffuse_share = 1.0 - s.blend.coat_f0 * ab.x - ab.y;
#if IMAGE_LIGHT_METHOD == IMAGE_LIGHT_METHOD_PREFILTERED
    r.specular = single * prefiltered_along(s.position, mirrored, roughness);
#elif IMAGE_LIGHT_METHOD == IMAGE_LIGHT_METHOD_DOMINANT
    r.specular = single * prefiltered_along(s.position, dominant_direction(s.normal, mirrored, s.alpha), roughness);
#elif IMAGE_LIGHT_METHOD == IMAGE_LIGHT_METHOD_MULTISCATTER
    r.specular = single * prefiltered_along(s.position, dominant_direction(s.normal, mirrored, s.alpha), roughness);
#else
    r.specular = sampled_reflection(s, n_dot_v);
#endif
#if IMAGE_LIGHT_METHOD >= IMAGE_LIGHT_METHOD_MULTISCATTER
    vec3 of_coat = multiple_scattering(s.blend.coat_f0, ab);
    r.multiple = mix(multiple_scattering(s.blend.metal_f0, ab), of_coat, s.blend.coated) *
                 diffuse_light(s.position, s.normal);
    r.specular += r.multiple;
    r.diffuse_share -= of_coat;
#endif
    r.diffuse_share = max(r.diffuse_share, 0.0);
#endif
    return r;
}
