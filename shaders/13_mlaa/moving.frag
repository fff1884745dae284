// Motion vectors of a scene's items.
#include "13_mlaa/put_motion.glsl"
#include "common/structs.h"

layout(scalar) uniform ViewBlock { CameraView view; };
layout(location = 0) in vec4 clip_now;
layout(location = 1) in vec4 clip_before;

void main() { put_motion(clip_now, clip_before, view.size); }
