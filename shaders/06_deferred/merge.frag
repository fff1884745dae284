// Merge of two pictures: the depth test keeps the nearer pixel.
uniform sampler2D color_map;
uniform sampler2D depth_map;

layout(location = 0) out vec4 color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depth_map, at, 0).r;
    if (depth == 0.0) discard;
    gl_FragDepth = depth;
    color = texelFetch(color_map, at, 0);
}
