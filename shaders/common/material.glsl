// A fragment's material: numbers from the buffer, textures where the material has them.
#include "common/image_uv.glsl"
#include "common/structs.h"

layout(scalar) readonly buffer MaterialBuffer { MaterialData materials[]; };
uniform sampler2D diffuse_map;

vec3 diffuse_color(MaterialData material, vec2 uv) {
    return material.diffuse * ((material.maps & DIFFUSE_MAP) != 0u ? texture(diffuse_map, image_uv(uv)).rgb : vec3(1.0));
}
