// A box of a city.
#include "15_terrain_water/no_sun_shadow.glsl"
#include "15_terrain_water/city_light.glsl"
#include "common/structs.h"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 on_wall;
layout(location = 3) flat in uvec2 kind_number;
layout(location = 4) in float thinned;
layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform ToSunBlock { vec3 to_sun; };

void main() {
    vec3 light = city_light_of(position, normal, on_wall, kind_number.x, kind_number.y, thinned, length(position - view.eye), to_sun);
    color = vec4(min(light, LARGEST_HALF), 1.0);
}
