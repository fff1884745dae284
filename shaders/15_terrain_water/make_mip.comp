// A mip level: the mean of 2x2 texels of the previous one, or of those that exist if its size is odd.
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D finer;
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(result)))) return;
    imageStore(result, at, textureLod(finer, (vec2(at) + 0.5) / vec2(imageSize(result)), 0.0));
}
