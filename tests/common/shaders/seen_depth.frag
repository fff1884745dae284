// The depth that it is tested against.
uniform sampler2D depth;
layout(location = 0) out vec4 color;

void main() { color = vec4(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r); }
