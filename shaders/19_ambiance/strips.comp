// Four strips side by side, with a thin line between two.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D strip_0, strip_1, strip_2, strip_3;
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(pixel, size))) return;
    int strip = min(((pixel.x + 1) * 4 - 1) / size.x, 3), first = size.x * strip / 4;
    ivec2 within = ivec2(pixel.x - first, pixel.y);
    vec3 light = strip == 0   ? texelFetch(strip_0, within, 0).rgb
                 : strip == 1 ? texelFetch(strip_1, within, 0).rgb
                 : strip == 2 ? texelFetch(strip_2, within, 0).rgb
                              : texelFetch(strip_3, within, 0).rgb;
    if (strip > 0 && within.x < max(size.y / 270, 1)) light = vec3(0.7);
    imageStore(result, pixel, vec4(light, 1.0));
}
