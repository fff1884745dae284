// A cross-fade of two pictures in linear light.
layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D before;
layout(rgba16f) uniform image2D picture;
layout(scalar) uniform MixBlock { float share; };

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    vec3 from = texelFetch(before, pixel, 0).rgb, to = imageLoad(picture, pixel).rgb;
    imageStore(picture, pixel, vec4(mix(from, to, share), 1.0));
}
