#version 460
layout(location = 0) flat out int number;

void main() {
    number = gl_InstanceIndex;  // the first instance of a draw is its number
    ivec2 pixel = ivec2(number % 400, number / 400) + ivec2(gl_VertexIndex & 1, gl_VertexIndex >> 1);
    gl_Position = vec4(vec2(pixel) / vec2(200, 125) - 1.0, 0.0, 1.0);  // of 400 x 250 pixels
}
