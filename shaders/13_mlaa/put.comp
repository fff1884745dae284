// Copies mixed pixels into the picture; every other pixel stays as it is, to the bit.
#define WORK_ACCESS readonly
#include "13_mlaa/work.glsl"

layout(local_size_x = 256) in;

layout(scalar) readonly buffer ListBuffer { uint listed[]; };
layout(rgba16f) readonly uniform image2D mixed;
layout(rgba16f) uniform image2D picture;

void main() {
    for (uint i = gl_GlobalInvocationID.x; i < work.listed_count; i += listed_threads * gl_NumWorkGroups.x) {
        ivec2 pixel = unpack_pixel(listed[i]);
        vec4 found = imageLoad(mixed, pixel);
        if (found.a > 0.0) imageStore(picture, pixel, vec4(found.rgb, imageLoad(picture, pixel).a));
    }
}
