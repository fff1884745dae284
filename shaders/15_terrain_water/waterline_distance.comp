// Distance to the nearest texel inside an object: in texels along its row, then in metres.
layout(local_size_x = 8, local_size_y = 8) in;

struct Line {
    int most;  // texels to either side
    float texel_m;
};
layout(scalar) uniform LineBlock { Line line; };
uniform sampler2D from;
layout(r32f) writeonly uniform image2D result;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), last = imageSize(result) - 1;
    if (any(greaterThan(at, last))) return;
    float none = float(line.most + 1);
#if VERTICAL
    float nearest = none * none;  // squared
    for (int i = 0; i <= line.most && float(i * i) < nearest; ++i)
        for (int side = -1; side <= 1; side += 2) {
            float row = texelFetch(from, ivec2(at.x, clamp(at.y + side * i, 0, last.y)), 0).r;
            nearest = min(nearest, row * row + float(i * i));
        }
    // Borders lie halfway between two texels.
    imageStore(result, at, vec4(max(sqrt(nearest) - 0.5, 0.0) * line.texel_m));
#else
    float nearest = none;
    for (int i = 0; i <= line.most && nearest == none; ++i)
        for (int side = -1; side <= 1; side += 2)
            if (texelFetch(from, ivec2(clamp(at.x + side * i, 0, last.x), at.y), 0).r > 0.5) nearest = float(i);
    imageStore(result, at, vec4(nearest));
#endif
}
