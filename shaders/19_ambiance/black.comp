// Black, where no scene is on.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) writeonly uniform image2D picture;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    imageStore(picture, pixel, vec4(0.0, 0.0, 0.0, 1.0));
}
