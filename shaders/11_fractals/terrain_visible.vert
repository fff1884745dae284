// Lifted vertices of the ground, for a visibility buffer: the item is the ring.
#include "11_fractals/terrain_data.h"
#include "common/structs.h"

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform TerrainNowBlock { TerrainNow terrain_now; };
layout(scalar) readonly buffer GroundBuffer { vec3 ground_vertices[]; };

layout(location = 7) flat out uint item;

void main() {
    int vertices = (terrain_now.cells + 1) * (terrain_now.cells + 1);
    item = uint(gl_InstanceIndex);
    gl_Position = view.view_projection * vec4(ground_vertices[gl_InstanceIndex * vertices + gl_VertexIndex], 1.0);
}
