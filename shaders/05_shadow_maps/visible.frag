// What a visibility buffer holds of a pixel: which item it shows, counted from 1, and which of its triangles.
layout(location = 7) flat in uint item;
layout(location = 0) out uvec2 visible;

void main() { visible = uvec2(item + 1u, uint(gl_PrimitiveID)); }
