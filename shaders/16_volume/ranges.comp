// The range of densities of each block: a workgroup for each.
#include "16_volume/skip_empty.glsl"

void main() { skip_empty(ivec3(gl_WorkGroupID)); }
