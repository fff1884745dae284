// The layers over the background.
layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D peeled;
layout(rgba16f) uniform image2D picture;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(picture)))) return;
    vec4 layers = texelFetch(peeled, at, 0), before = imageLoad(picture, at);
    if (layers.a == 1.0) return;
    imageStore(picture, at, vec4(layers.rgb + layers.a * before.rgb, before.a));
}
