// The ground's vertices, each lifted once, for all passes that draw and shade its triangles.
#include "11_fractals/grid_vertex.glsl"

layout(local_size_x = 64) in;

layout(scalar) writeonly buffer GroundBuffer { vec3 ground_vertices[]; };  // ring by ring

void main() {
    int number = int(gl_GlobalInvocationID.x), ring = int(gl_GlobalInvocationID.y);
    int vertices = (terrain_now.cells + 1) * (terrain_now.cells + 1);
    if (number < vertices) ground_vertices[ring * vertices + number] = grid_vertex(number, ring);
}
