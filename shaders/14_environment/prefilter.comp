// One face of one level of the prefiltered cube: the reflection of a surface of that roughness, viewed along its
// normal.
#include "common/environment_map.glsl"
#include "14_environment/ggx.glsl"
#include "14_environment/importance_sample_ggx.glsl"
#include "common/structs.h"

layout(local_size_x = 8, local_size_y = 8) in;

uniform samplerCube radiance;
layout(scalar) uniform FaceNowBlock { uint face; float roughness; } face_now;
layout(scalar) uniform PrefilterBlock { int samples; float bias; } prefilter;
layout(rgba16f) writeonly uniform image2D face_level;

// [prefilter]
// B. Karis, "Real Shading in Unreal Engine 4", 2013: assumes normal and view equal, and weighs samples by n·l. M.
// Colbert and J. Krivanek, "GPU-Based Importance Sampling", GPU Gems 3, 2007: each is read from the level with texels
// as large as its solid angle.
vec3 filtered(vec3 normal, float alpha, uint samples, float bias) {
    mat3 frame = frame_around(normal);
    float texels = float(textureSize(radiance, 0).x), texel_rad2 = 4.0 * pi / (6.0 * texels * texels);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (uint i = 0u; i < samples; ++i) {
        vec3 half_vector = importance_sample_ggx(hammersley(i, samples).yx, alpha);
        vec3 to_light = 2.0 * half_vector.z * half_vector - vec3(0.0, 0.0, 1.0);
        if (to_light.z <= 0.0) continue;
        // n·h and v·h are equal here: the density of l is D / 4.
        float density = 0.25 * ggx_density(half_vector.z, alpha);
        float lod = 0.5 * log2(1.0 / (float(samples) * density * texel_rad2)) + bias;
        sum += textureLod(radiance, frame * to_light, max(lod, 0.0)).rgb * to_light.z;
        weights += to_light.z;
    }
    return weights > 0.0 ? sum / weights : textureLod(radiance, normal, 0.0).rgb;
}
// [/prefilter]

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(face_level);
    if (any(greaterThanEqual(texel, size))) return;
    vec3 normal = cube_direction(uvec3(texel, face_now.face), float(size.x));
    float alpha = face_now.roughness * face_now.roughness;
    vec3 light = alpha > 0.0 ? filtered(normal, alpha, uint(prefilter.samples), prefilter.bias)
                             : textureLod(radiance, normal, 0.0).rgb;
    imageStore(face_level, texel, vec4(min(light, LARGEST_HALF), 1.0));
}
