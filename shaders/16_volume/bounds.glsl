// The part of a ray inside the volume's ball or box.
#include "16_volume/ray_box.glsl"
#include "16_volume/ray_shell.glsl"

vec2 volume_range(vec3 origin, vec3 direction) {
    if (volume_now.radius_m > 0.0) return ray_shell(origin, direction, volume_now.radius_m);
    return ray_box(volume_now.to_volume * origin, volume_now.to_volume * direction, volume_now.half_m);
}
