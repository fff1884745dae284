// Arithmetic load that keeps a GPU at full clock between measured frames.
layout(local_size_x = 64) in;

layout(scalar) writeonly buffer LoadBuffer { float load[]; };

void main() {
    float x = float(gl_GlobalInvocationID.x);
    for (int i = 0; i < 4096; ++i) x = fma(x, 0.999, 1.0);
    if (x == 0.5) load[0] = x;  // never true; keeps the loop from being optimised out
}
