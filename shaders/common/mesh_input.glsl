// Vertex shader input: vertices by gl_VertexIndex, instances by gl_InstanceIndex, the camera.
#include "common/structs.h"

layout(scalar) readonly buffer VertexBuffer { Vertex vertices[]; };
layout(scalar) readonly buffer InstanceBuffer { Instance instances[]; };
layout(scalar) uniform ViewBlock { CameraView view; };
