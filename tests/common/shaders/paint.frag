layout(scalar) uniform PaintBlock { vec4 first, second; } paint;
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;

void main() {
    first = paint.first;
    second = paint.second;
}
