// The light before the volume attenuates it.
#if VOLUME_LIGHT == VOLUME_LIGHT_VOLUME
uniform sampler3D volume_light;
#endif

// Irradiance at a place in the volume, as if nothing stood in the light's way.
vec3 unattenuated_light(vec3 position) {
    vec3 way = volume_now.light_at - position;
    // A lamp has a size: nearer than 0.1 m its light does not grow.
    float fall = volume_now.is_near > 0.0 ? 1.0 / max(dot(way, way), 0.01) : 1.0;
    return volume_now.light * fall;
}
