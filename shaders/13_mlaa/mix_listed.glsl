// Mixes each listed pixel with its neighbours by weights_of(), defined by the includer. All that it mixes lie beside an
// edge as well: their light is read from where the pass that found edges kept it.
#include "13_mlaa/blend.glsl"
#include "13_mlaa/picture.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;

layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(rgba16f) writeonly uniform image2D into;
shared uint changed_here;

void main() {
    if (gl_LocalInvocationIndex == 0u) changed_here = 0u;
    barrier();
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        ivec2 pixel = unpack_pixel(listed[i]);
        vec4 weights = weights_of(pixel);
        if (!any(greaterThan(weights, vec4(0.0)))) continue;  // it stays as it is, to the bit
        vec3 mixed = blend(light_at(pixel), light_at(pixel + ivec2(-1, 0)), light_at(pixel + ivec2(1, 0)),
                           light_at(pixel + ivec2(0, -1)), light_at(pixel + ivec2(0, 1)), weights);
        imageStore(into, pixel, vec4(mixed, texelFetch(picture, pixel, 0).a));
        atomicAdd(changed_here, 1u);
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u && changed_here > 0u) atomicAdd(work.changed_count, changed_here);
}
