// The mean of four pictures, as they come.
layout(local_size_x = 16, local_size_y = 16) in;

layout(scalar) uniform SampleBlock { int sample_index; };
layout(rgba16f) uniform image2D hdr;
layout(rgba32f) uniform image2D sum;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(hdr)))) return;
    vec4 light = imageLoad(hdr, pixel);
    if (sample_index > 0) light += imageLoad(sum, pixel);  // the first sample overwrites the old contents
    if (sample_index < 3) imageStore(sum, pixel, light);
    else imageStore(hdr, pixel, 0.25 * light);
}
