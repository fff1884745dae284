// The layers over the background.
layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D peeled, passed;
layout(rgba16f) uniform image2D picture;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(picture)))) return;
    vec3 layers = texelFetch(peeled, at, 0).rgb, left = texelFetch(passed, at, 0).rgb;
    vec4 before = imageLoad(picture, at);
    if (left == vec3(1.0)) return;
    imageStore(picture, at, vec4(layers + left * before.rgb, before.a));
}
