// Reflections by sums: some directions for each pixel, or all texels of the environment.
#include "common/environment_map.glsl"
#include "14_environment/cube_texel.glsl"
#include "14_environment/importance_sample_ggx.glsl"

// Whether light from a direction (unit length, world space) reaches a point. Defined by the includer: by
// 14_environment/unoccluded.glsl, without occlusion, or by rays.
bool light_arrives(vec3 position, vec3 direction);

uniform sampler2DArray image_light_texels;  // image_light_radiance as six layers
layout(scalar) uniform ImageLightBlock { int samples; float sample_bias; } image_light;

// Number of samples whose solid angle chooses a level. A level mixes what a ray finds hidden with what is open beside it:
// where rays ask, that must not depend on their number. Each pixel then shifts its points.
#ifdef OCCLUDED
vec2 sample_shift = vec2(0.0);
float samples_of_level(uint samples) { return 4096.0; }
vec2 sample_point(uint i, uint samples) { return fract(hammersley(i, samples) + sample_shift); }
#else
float samples_of_level(uint samples) { return float(samples); }
vec2 sample_point(uint i, uint samples) { return hammersley(i, samples); }
#endif

// M. Colbert and J. Krivanek, "GPU-Based Importance Sampling", GPU Gems 3, 2007, chapter 20: as the prefiltered cube's, but
// with this pixel's own view. The sum is not split, and n·v is not taken for 1.
vec3 reflection_of_samples(LitFromAround s, float n_dot_v, uint samples, float bias) {
    mat3 frame = frame_around(s.normal);
    vec3 to_eye = s.to_eye * frame;
    to_eye = vec3(to_eye.xy * sqrt((1.0 - n_dot_v * n_dot_v) / max(dot(to_eye.xy, to_eye.xy), 1e-12)), n_dot_v);
    float texel_rad2 = 4.0 * pi / (6.0 * image_light_state.texels * image_light_state.texels);
    float alpha = max(s.alpha, 1e-3);
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < samples; ++i) {
        vec3 half_vector = importance_sample_ggx(sample_point(i, samples).yx, alpha);
        float v_dot_h = dot(to_eye, half_vector);
        vec3 to_light = 2.0 * v_dot_h * half_vector - to_eye;
        if (to_light.z <= 0.0 || v_dot_h <= 0.0) continue;
        float density = ggx_density(half_vector.z, alpha) * half_vector.z / (4.0 * v_dot_h);
        float lod = 0.5 * log2(1.0 / (samples_of_level(samples) * density * texel_rad2)) + bias;
        vec3 fresnel = s.f0 + (1.0 - s.f0) * schlick_power(v_dot_h);
        float weight = ggx_visibility(to_light.z, n_dot_v, alpha) * to_light.z * 4.0 * v_dot_h / half_vector.z;
        vec3 direction = frame * to_light;
        if (light_arrives(s.position, direction))
            sum += fresnel * weight * radiance_along(s.position, direction, max(lod, 0.0));
    }
    return sum / float(samples);
}

// Irradiance over pi by directions distributed as the cosine is.
vec3 diffuse_of_samples(vec3 position, vec3 normal, uint samples) {
    mat3 frame = frame_around(normal);
    float texel_rad2 = 4.0 * pi / (6.0 * image_light_state.texels * image_light_state.texels);
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < samples; ++i) {
        vec2 random = sample_point(i, samples);
        float cosine = sqrt(1.0 - random.x), sine = sqrt(random.x), phi = 2.0 * pi * random.y;
        vec3 direction = frame * vec3(sine * cos(phi), sine * sin(phi), cosine);
        float lod = 0.5 * log2(pi / (samples_of_level(samples) * max(cosine, 1e-3) * texel_rad2)) + 1.0;
        if (light_arrives(position, direction)) sum += radiance_along(position, direction, max(lod, 0.0));
    }
    return sum / float(samples);
}

// Every texel of a level of the cube times its solid angle, with GGX in full: 32 by 32 texels a face where the lobe is at
// least four of them wide, else 64 by 64. A lobe that is narrower than four of those is sampled, from the finest level.
// `level` is a constant wherever it is called: Mesa 22.3 takes one level for all of a texelFetch's invocations.
vec3 sum_of_texels(LitFromAround s, float n_dot_v, int level) {
    uint size = uint(textureSize(image_light_texels, level).x);
    vec3 normal = environment_space(s.normal), to_eye = environment_space(s.to_eye), sum = vec3(0.0);
    for (uint n = 0u; n < 6u * size * size; ++n) {
        uvec3 texel = uvec3(n % size, n / size % size, n / (size * size));
        vec3 to_light = cube_direction(texel, float(size)), between = to_light + to_eye;
        float n_dot_l = dot(normal, to_light);
        if (n_dot_l <= 0.0 || dot(between, between) < 1e-12) continue;
        vec3 half_vector = normalize(between);
        vec3 fresnel = s.f0 + (1.0 - s.f0) * schlick_power(dot(to_eye, half_vector));
        float weight = ggx_density(clamp(dot(normal, half_vector), 0.0, 1.0), s.alpha) *
                       ggx_visibility(n_dot_l, n_dot_v, s.alpha) * n_dot_l * texel_solid_angle(texel.xy, float(size));
        sum += fresnel * weight * texelFetch(image_light_texels, ivec3(texel), level).rgb;
    }
    return environment_scale.intensity * sum;
}

vec3 reflection_of_texels(LitFromAround s, float n_dot_v) {
    float wide = 2.0 * atan(s.alpha) / 4.0, quarter = 0.5 * pi;  // as a texel may be; as a face is
    if (image_light_state.has_box == 0u) {
        if (wide >= quarter / float(textureSize(image_light_texels, 3).x)) return sum_of_texels(s, n_dot_v, 3);
        if (wide >= quarter / float(textureSize(image_light_texels, 2).x)) return sum_of_texels(s, n_dot_v, 2);
    }
    return reflection_of_samples(s, n_dot_v, 4096u, 0.0);
}

vec3 sampled_reflection(LitFromAround s, float n_dot_v) {
#if IMAGE_LIGHT_METHOD == IMAGE_LIGHT_METHOD_TRUTH
    return reflection_of_texels(s, n_dot_v);
#else
    return reflection_of_samples(s, n_dot_v, uint(image_light.samples), image_light.sample_bias);
#endif
}
