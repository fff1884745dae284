// Visibility buffer: item, counted from 1, and triangle.
layout(location = 7) flat in uint item;
layout(location = 0) out uvec2 visible;

void main() { visible = uvec2(item + 1u, uint(gl_PrimitiveID)); }
