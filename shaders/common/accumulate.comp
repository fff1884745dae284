// Running mean of linear light over pictures shifted within a pixel.
layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D hdr;
layout(rgba32f) uniform image2D mean;
layout(scalar) uniform WeightBlock { float weight; };  // 1 / number of pictures so far, this one included

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(mean)))) return;
    vec4 now = texelFetch(hdr, pixel, 0);
    // Overwriting, not adding: the image may hold NaN before the first picture.
    vec4 before = weight == 1.0 ? now : imageLoad(mean, pixel);
    imageStore(mean, pixel, before + (now - before) * weight);
}
