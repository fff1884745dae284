// The ground's vertices, each lifted as it is drawn.
#include "11_fractals/grid_vertex.glsl"
#include "common/structs.h"

layout(scalar) uniform ViewBlock { CameraView view; };

layout(location = 0) out vec3 position;

void main() {
    position = grid_vertex(gl_VertexIndex, gl_InstanceIndex);
    gl_Position = view.view_projection * vec4(position, 1.0);
}
