// Shows the history; alpha stays.
layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D light;
layout(rgba16f) uniform image2D picture;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    imageStore(picture, pixel, vec4(texelFetch(light, pixel, 0).rgb, imageLoad(picture, pixel).a));
}
