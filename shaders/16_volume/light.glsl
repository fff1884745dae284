// The light at a place in the volume.
#include "16_volume/light_through.glsl"
#if VOLUME_LIGHT == VOLUME_LIGHT_VOLUME
uniform sampler3D volume_light;
#endif

// [arriving]
// Radiance of a white point, times pi, without emission.
vec3 light_at(vec3 position) {
#if VOLUME_LIGHT == VOLUME_LIGHT_NONE
    return vec3(0.0);
#else
    vec3 way = volume_now.light_at - position;
    // A lamp has a size: nearer than 0.1 m its light does not grow.
    float fall = volume_now.is_near > 0.0 ? 1.0 / max(dot(way, way), 0.01) : 1.0;
#if VOLUME_LIGHT == VOLUME_LIGHT_MARCH
    return volume_now.light * fall * light_through(position, 0.5, volume.light_steps);
#else
    return volume_now.light * fall * textureLod(volume_light, to_texture(position), 0.0).r;
#endif
#endif
}
// [/arriving]
