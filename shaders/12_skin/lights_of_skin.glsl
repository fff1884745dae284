// The lights that reach a point, one by one: skin reflects each in its own way.
#include "03_attenuation/lighting.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "05_shadow_maps/map_depth.glsl"

struct SkinLight {
    vec3 to_light;   // unit length
    vec3 radiance;   // what a matt white surface that faces the light shows where nothing is in the way
    float visible;   // 0 to 1; 1 where the surface faces away
};

uint skin_lights() { return lights_data.length(); }

SkinLight skin_light(uint index, vec3 position, vec3 facing) {
    Arriving arriving = arriving_light(lights_data[index], position, lights.fade_k);
    bool faces = dot(facing, arriving.to_light) > 0.0;
    float visible = faces && arriving.radiance != vec3(0.0) ? light_visibility(index, position, facing, arriving.to_light) : 1.0;
    return SkinLight(arriving.to_light, arriving.radiance, visible);
}

// [thickness]
// How far light has gone through the surface to come out here, in mm: from where the light's map has its nearest surface.
// The point is moved inwards, so that at an edge the map does not show what is beside it. Below 0: no map.
float thickness_mm(uint index, vec3 position, vec3 facing, float inwards_m) {
#if SHADOW_METHOD == SHADOW_METHOD_NONE
    return -1.0;
#else
    ShadowLight light = shadow_lights[index];
    if (light.views == 0u) return -1.0;
    vec3 inside = position - inwards_m * facing;
    ShadowView map = shadow_views[view_of(light, inside)];
    if (map.layer == NO_LAYER) return -1.0;
    vec3 place = light_clip_position(map.to_clip, inside);
    if (place.z <= 0.0) return -1.0;
    return 1000.0 * max(map_distance(map, place.z) - map_distance(map, read_depth(place.xy, map.layer)), 0.0);
#endif
}
// [/thickness]
