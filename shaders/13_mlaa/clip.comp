// Clips light to the displayable range before pixels are mixed.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) uniform image2D hdr;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(hdr)))) return;
    imageStore(hdr, pixel, vec4(min(imageLoad(hdr, pixel).rgb, 1.0), 1.0));
}
