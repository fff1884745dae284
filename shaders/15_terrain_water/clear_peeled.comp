// Before the first layer: no light, and all of the background is seen.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) writeonly uniform image2D peeled;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, imageSize(peeled)))) imageStore(peeled, at, vec4(0.0, 0.0, 0.0, 1.0));
}
