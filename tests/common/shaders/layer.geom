// Instance i into layer i.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
layout(location = 0) flat in int instance[];

void main() {
    for (int i = 0; i < 3; ++i) {
        gl_Layer = instance[0];
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
}
