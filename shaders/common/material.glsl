// A fragment's material: numbers from the buffer, textures where the material has them.
#include "common/structs.h"

layout(scalar) readonly buffer MaterialBuffer { MaterialData materials[]; };
uniform sampler2D diffuse_map;

vec3 diffuse_color(MaterialData material, vec2 uv, float lod_bias) {
    if ((material.maps & DIFFUSE_MAP) == 0u) return material.diffuse;
    return material.diffuse * texture(diffuse_map, image_uv(uv), lod_bias).rgb;
}

// Emissive maps are not read before chapter 04: without its map, the factor would be a lamp.
vec3 emitted_color(MaterialData material) {
    return (material.maps & EMISSIVE_MAP) == 0u ? material.emissive : vec3(0.0);
}
