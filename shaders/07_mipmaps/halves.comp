// The left half of one picture beside the right half of another, with a line between them.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D left;
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    int middle = size.x / 2;
    if (at.y >= size.y || at.x > middle) return;
    imageStore(result, at, at.x < middle - 1 ? texelFetch(left, at, 0) : vec4(1.0));
}
