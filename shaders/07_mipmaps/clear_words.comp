// Every word of a buffer becomes 0.
layout(local_size_x = 64) in;

layout(scalar) writeonly buffer WordBuffer { uint words[]; };

void main() {
    if (gl_GlobalInvocationID.x < words.length()) words[gl_GlobalInvocationID.x] = 0u;
}
