// Next mip of a moment map; means of moments are moments.
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D source;
writeonly uniform image2D result;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(result)))) return;
    ivec2 last = textureSize(source, 0) - 1;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) sum += texelFetch(source, min(2 * at + ivec2(i & 1, i >> 1), last), 0);
    imageStore(result, at, 0.25 * sum);
}
