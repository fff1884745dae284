// The part of a ray inside the volume's ball or box.
#include "16_volume/ray_shell.glsl"

vec2 ray_box(vec3 origin, vec3 direction, vec3 half_m) {
    vec3 safe = mix(direction, vec3(1e-12), lessThan(abs(direction), vec3(1e-12)));
    vec3 one = (-half_m - origin) / safe, other = (half_m - origin) / safe;
    vec3 near = min(one, other), far = max(one, other);
    return vec2(max(max(near.x, near.y), max(near.z, 0.0)), min(far.x, min(far.y, far.z)));
}

vec2 volume_range(vec3 origin, vec3 direction) {
    if (volume_now.radius_m > 0.0) return ray_shell(origin, direction, volume_now.radius_m);
    return ray_box(volume_now.to_volume * origin, volume_now.to_volume * direction, volume_now.half_m);
}
