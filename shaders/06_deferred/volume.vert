// Vertex transform of light volumes.
#include "common/structs.h"
#include "01_obj/transform.glsl"
#include "06_deferred/light_volume_data.h"

layout(scalar) readonly buffer CornerBuffer { vec3 corners[]; };
layout(scalar) readonly buffer VolumeBuffer { LightVolumeData volumes[]; };
layout(scalar) uniform ViewBlock { CameraView view; };
layout(location = 0) flat out uint light;

void main() {
    LightVolumeData volume = volumes[gl_InstanceIndex];
    light = volume.light;
    gl_Position = world_to_clip(view.view_projection, position_to_world(volume.to_world, corners[gl_VertexIndex]));
}
