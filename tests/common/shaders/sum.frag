// Two bindings that change with every draw.
layout(scalar) readonly buffer FirstBuffer { float first[]; };
layout(scalar) readonly buffer SecondBuffer { float second[]; };
layout(location = 0) out vec4 color;

void main() { color = vec4(first[0] + second[0]); }
