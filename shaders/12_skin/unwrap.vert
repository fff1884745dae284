// Unwraps a surface: a vertex stands where its texture coordinates are.
#include "common/mesh_input.glsl"
#include "04_surface_maps/surface_varyings.glsl"

layout(scalar) readonly buffer TangentBuffer { TangentFrame tangents[]; };
layout(scalar) readonly buffer ChartBuffer { uint charts[]; };
layout(location = 11) flat out uint chart;

void main() {
    Vertex vertex = vertices[gl_VertexIndex];
    set_varyings(vertex, tangents[gl_VertexIndex], instances[gl_InstanceIndex]);
    chart = charts[gl_VertexIndex];
    // Row 0 of an image is its top, where v is 1: as image_uv() says.
    gl_Position = vec4(2.0 * uv.x - 1.0, 1.0 - 2.0 * uv.y, 0.5, 1.0);
}
