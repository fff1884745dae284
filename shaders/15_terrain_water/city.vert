// A box of a city, on the ground; without its bottom.
#include "15_terrain_water/city_data.h"
#include "15_terrain_water/ground.glsl"
#include "common/structs.h"

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) readonly buffer CityBoxesBlock { CityBox city_boxes[]; };

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 on_wall;  // metres along the wall and up, height of the box
layout(location = 3) flat out uvec2 kind_number;
layout(location = 4) out float thinned;  // share of its light that a lamp's surface keeps

layout(scalar) uniform CityLightBlock { vec2 city_light; };  // radiance of a lit window, a pixel's angle

void main() {
    CityBox box = city_boxes[gl_InstanceIndex];
    // Faces: four walls, then the roof. Along u and v, with a cross product pointing outwards.
    int face = gl_VertexIndex / 6, corner = gl_VertexIndex % 6;
    vec2 uv = vec2(corner == 1 || corner == 2 || corner == 4 ? 1.0 : -1.0, corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0);
    vec3 out_of = face == 0 ? vec3(0, 0, 1) : face == 1 ? vec3(1, 0, 0) : face == 2 ? vec3(0, 0, -1) : face == 3 ? vec3(-1, 0, 0) : vec3(0, 1, 0);
    vec3 u = face == 4 ? vec3(1, 0, 0) : vec3(out_of.z, 0.0, -out_of.x), v = face == 4 ? vec3(0, 0, -1) : vec3(0, 1, 0);
    // A lamp smaller than a pixel would come and go: it is drawn as wide as one, and less bright.
    vec3 half_size = box.half_size;
    thinned = 1.0;
    if (box.kind == CITY_LAMP) {
        float pixel_m = length(vec3(box.place.x, 0.0, box.place.y) - view.eye) * city_light.y, wide = max(half_size.x, 0.75 * pixel_m);
        thinned = half_size.x * half_size.y / (wide * wide);
        half_size = vec3(wide);
    }
    vec3 local = half_size * (out_of + uv.x * u + uv.y * v);
    float c = cos(box.yaw), s = sin(box.yaw), ground_m = land_height(box.place);
    mat3 turn = mat3(vec3(c, 0, -s), vec3(0, 1, 0), vec3(s, 0, c));
    position = turn * local + vec3(box.place.x, ground_m + box.base_m + box.half_size.y, box.place.y);
    normal = turn * out_of;
    on_wall = vec3(dot(local + half_size, abs(u)), position.y - ground_m, box.base_m + 2.0 * box.half_size.y);
    kind_number = uvec2(box.kind, box.number);
    gl_Position = ground_m < 1.0 ? vec4(0.0, 0.0, 0.0, 1.0) : view.view_projection * vec4(position, 1.0);
}
