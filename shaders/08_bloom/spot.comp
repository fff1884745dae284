// Black, but for one pixel's worth of light near the middle, which may lie across two pixels.
layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) uniform SpotXBlock { float spot_x; };  // pixels to the right
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(pixel, size))) return;
    vec2 from_spot = vec2(pixel - size / 2) - vec2(spot_x, 0.0);
    float share = max(0.0, 1.0 - abs(from_spot.x)) * (from_spot.y == 0.0 ? 1.0 : 0.0);
    imageStore(result, pixel, vec4(vec3(10000.0 * share), 1.0));
}
