layout(scalar) uniform PaintBlock { vec4 first, second; } paint;
layout(location = 0) out vec4 first;

void main() { first = paint.first; }
