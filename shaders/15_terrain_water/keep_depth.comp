// The picture and its depth before the water, to be read while the water is drawn.
layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D picture;
uniform sampler2D depth;
layout(rgba16f) writeonly uniform image2D kept;
layout(r32f) writeonly uniform image2D kept_depth;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(kept)))) return;
    imageStore(kept, at, texelFetch(picture, at, 0));
    imageStore(kept_depth, at, vec4(texelFetch(depth, at, 0).r));
}
