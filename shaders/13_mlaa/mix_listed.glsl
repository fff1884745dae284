// Mixes each listed pixel with its neighbours by weights_of(), defined by the includer. Results wait in an image of
// their own: neighbours still read the original picture.
#include "13_mlaa/blend.glsl"
#include "13_mlaa/picture.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;

layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(rgba16f) writeonly uniform image2D mixed;  // alpha 0: the pixel stays as it is
shared uint changed_here;

// [mix]
void main() {
    if (gl_LocalInvocationIndex == 0u) changed_here = 0u;
    barrier();
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        ivec2 pixel = unpack_pixel(listed[i]);
        vec4 weights = weights_of(pixel);
        bool changes = any(greaterThan(weights, vec4(0.0)));
        vec4 result = vec4(0.0);
        if (changes) {
            result = vec4(blend(light_at(pixel), light_at(pixel + ivec2(-1, 0)), light_at(pixel + ivec2(1, 0)),
                                light_at(pixel + ivec2(0, -1)), light_at(pixel + ivec2(0, 1)), weights), 1.0);
            atomicAdd(changed_here, 1u);
        }
        imageStore(mixed, pixel, result);
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u && changed_here > 0u) atomicAdd(work.changed_count, changed_here);
}
// [/mix]
