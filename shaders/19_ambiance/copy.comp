// A picture as it is, into another image.
layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D from;
layout(rgba16f) writeonly uniform image2D into;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(into)))) return;
    imageStore(into, pixel, texelFetch(from, pixel, 0));
}
