// A picture of one colour, for drawing over it in compute.
layout(local_size_x = 16, local_size_y = 16) in;

layout(rgba16f) writeonly uniform image2D result;
layout(scalar) uniform BackgroundBlock { vec4 background; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, imageSize(result)))) imageStore(result, at, background);
}
