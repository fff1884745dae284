// Material of a fragment: numbers from the buffer, times textures where it has any.
#include "common/structs.h"

layout(scalar) readonly buffer MaterialBuffer { MaterialData materials[]; };
uniform sampler2D diffuse_map;

vec3 diffuse_color(MaterialData material, vec2 uv, float lod_bias) {
    if ((material.maps & DIFFUSE_MAP) == 0u) return material.diffuse;
    return material.diffuse * texture(diffuse_map, image_uv(uv), lod_bias).rgb;
}

// No emission: emissive maps are read from chapter 04 on, and the factor alone would make the whole surface glow.
vec3 emitted_color(MaterialData material) {
    return (material.maps & EMISSIVE_MAP) == 0u ? material.emissive : vec3(0.0);
}
