// Transmittance from the light to each point of the volume, or optical depth, at half resolution.
#include "common/structs.h"
#include "16_volume/volume_inputs.glsl"
#include "16_volume/bounds.glsl"
#include "16_volume/correct_opacity.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(scalar) uniform VolumeBlock { int light_steps; } volume;
#include "16_volume/light_through.glsl"
layout(r16f) writeonly uniform image3D result;

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID), size = imageSize(result);
    if (any(greaterThanEqual(at, size))) return;
    vec3 position = ((vec3(at) + 0.5) / vec3(size) * 2.0 - 1.0) * volume_now.half_m * volume_now.to_volume;
#if VOLUME_SCATTERING == VOLUME_SCATTERING_NONE
    imageStore(result, at, vec4(light_through(position, 0.5, volume.light_steps)));
#else
    imageStore(result, at, vec4(min(light_depth(position, 0.5, volume.light_steps), LARGEST_HALF)));
#endif
}
