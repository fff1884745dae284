// Twice the middle of the source.
uniform sampler2D source;
layout(location = 0) out vec4 color;

void main() { color = 2.0 * textureLod(source, vec2(0.5), 0.0); }
