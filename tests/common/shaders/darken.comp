// Halves the light of a picture in place; the example of docs/framework.md.
layout(local_size_x = 8, local_size_y = 8) in;

// [in_place_shader]
layout(rgba16f) uniform image2D picture;  // stated in reads and in writes
// [/in_place_shader]

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    // [in_place_body]
    vec4 light = imageLoad(picture, pixel);
    imageStore(picture, pixel, vec4(0.5 * light.rgb, light.a));
    // [/in_place_body]
}
