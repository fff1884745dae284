// A rectangle of one colour.
layout(location = 0) flat in vec4 quad_color;
layout(location = 0) out vec4 color;

void main() { color = quad_color; }
