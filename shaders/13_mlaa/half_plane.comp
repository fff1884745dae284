// White where a pixel's middle lies below a line, black elsewhere.
layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) uniform LineBlock { vec2 normal, point; } line;  // pixels; y grows downwards
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    float light = dot(vec2(pixel) - line.point, line.normal) > 0.0 ? 1.0 : 0.0;
    imageStore(result, pixel, vec4(vec3(light), 1.0));
}
