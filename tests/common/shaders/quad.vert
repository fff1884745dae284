// Two triangles over a rectangle, counter-clockwise: a test's draw call.
layout(scalar) uniform QuadBlock {
    vec4 rectangle;             // left, top, right, bottom in clip space
    float depth, depth_right;  // at its left and right edge
} quad;
layout(location = 0) flat out int instance;

void main() {
    const vec2 corners[6] = vec2[6](vec2(0, 0), vec2(0, 1), vec2(1, 1), vec2(0, 0), vec2(1, 1), vec2(1, 0));
    const vec2 corner = corners[gl_VertexIndex];
    gl_Position = vec4(mix(quad.rectangle.xy, quad.rectangle.zw, corner), mix(quad.depth, quad.depth_right, corner.x), 1);
    instance = gl_InstanceIndex;
}
