// Rings of water around the camera, each wider than the one before, as far as the picture goes.
#include "common/structs.h"
#include "15_terrain_water/water_surface.glsl"

layout(scalar) uniform ViewBlock { CameraView view; };

invariant gl_Position;  // two passes draw the same surface, and the second meets the first one's depth

layout(location = 0) out vec2 at_rest;
layout(location = 1) out vec3 position;

void main() {
    uvec2 place = uvec2(uint(gl_VertexIndex) % (SPOKES + 1u), uint(gl_VertexIndex) / (SPOKES + 1u));
    float angle = water_now.from_rad + water_now.wide_rad * float(place.x) / float(SPOKES);
    // The innermost ring is a point below the camera.
    float radius = place.y == 0u ? 0.0 : water_now.first_m * pow(water_now.growth, float(place.y - 1u));
    at_rest = water_now.center + radius * vec2(cos(angle), sin(angle));
    vec3 moved = water_at(at_rest, ring_spacing(radius)).moved;
    position = vec3(at_rest.x, water_now.level_m, at_rest.y) + moved;
    gl_Position = view.view_projection * vec4(position, 1.0);
}
