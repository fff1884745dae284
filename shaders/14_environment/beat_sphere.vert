// The sphere's vertices, each moved along its normal by music and by the surroundings' brightness.
#include "14_environment/beat_surface.glsl"
#include "common/structs.h"

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) readonly buffer DirectionBuffer { vec3 directions[]; };

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out float raised;  // by the bands, a share of the radius

// [displace]
void main() {
    vec3 n = directions[gl_VertexIndex];
    raised = band_heights(n).w;
    position = beat_now.center + beat_now.radius_m * place_above(n);
    normal = displaced_normal(n);
    gl_Position = view.view_projection * vec4(position, 1.0);
}
// [/displace]
