// One level of a depth pyramid from the one above it: the farthest of the texels that it covers.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D source;
layout(r32f) writeonly uniform image2D level;

// [farthest]
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(level), from = textureSize(source, 0);
    if (any(greaterThanEqual(at, size))) return;
    ivec2 last = mix(2 * at + 1, from - 1, equal(at, size - 1));  // of an odd size the last one covers three
    float farthest = 1.0;
    for (int y = 2 * at.y; y <= last.y; ++y)
        for (int x = 2 * at.x; x <= last.x; ++x) farthest = min(farthest, texelFetch(source, ivec2(x, y), 0).r);
    imageStore(level, at, vec4(farthest));
}
// [/farthest]
