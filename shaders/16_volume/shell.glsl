// Shell of the sphere: thin glass with a noisy normal, over the volume.
#include "common/schlick.glsl"
#include "16_volume/noise_methods.glsl"
#include "16_volume/surroundings.glsl"

vec3 shell_over(vec3 light, vec3 position, vec3 along) {
    vec3 normal = position / volume_now.radius_m;
    // The slope of the noise by differences, a tenth of a cell apart.
    vec3 at = volume.shell_scale * normal;
    float here = moving_noise(at, volume_now.moment);
    vec3 slope = vec3(moving_noise(at + vec3(0.1, 0.0, 0.0), volume_now.moment),
                      moving_noise(at + vec3(0.0, 0.1, 0.0), volume_now.moment),
                      moving_noise(at + vec3(0.0, 0.0, 0.1), volume_now.moment)) - here;
    vec3 bumped = normalize(normal - volume.shell_bumps * 10.0 * (slope - normal * dot(slope, normal)));
    float facing = clamp(-dot(bumped, along), 0.0, 1.0);
    float mirrored = volume.shell_strength * schlick(facing, 0.04);
    return mix(light, surroundings(reflect(along, bumped)), clamp(mirrored, 0.0, 1.0));
}
